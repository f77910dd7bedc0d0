# Of the vectors of a frame only those have a name that something else speaks of.

DELETE {
    ?frame ?property ?vector .
    ?body geom:simplices ?vector .
    ?vector ?said ?value .
} WHERE {
    VALUES ?property { geom:vector-x geom:vector-y geom:vector-z }
    ?frame ?property ?vector .
    FILTER NOT EXISTS {
        ?user ?use ?vector .
        FILTER (?use NOT IN (geom:vector-x, geom:vector-y, geom:vector-z, geom:simplices))
    }
    ?vector ?said ?value .
    OPTIONAL { ?body geom:simplices ?vector }
} ;

DELETE { ?frame a geom:OriginVectorsXYZ }
WHERE {
    ?frame a geom:OriginVectorsXYZ .
    FILTER NOT EXISTS { ?frame geom:vector-x ?x ; geom:vector-y ?y ; geom:vector-z ?z }
}
