# The frame of a shape, an inertia or a joint that is nowhere else than another frame of the body is
# that frame.  Those which authors have named stay.

INSERT {
    ?frame ir:replaced-by ?base .
    ?origin ir:replaced-by ?point .
} WHERE {
    { ?owner kin:attached-to|kc:between-attachments ?frame }
    UNION { ?user dyn-coord:as-seen-by ?frame ; dyn-coord:of-inertia/dyn-ent:of-body ?owner }
    FILTER (STRSTARTS(STR(?frame), CONCAT(STR(?owner), "/")))
    ?pose a geom-rel:Pose ;
        geom-rel:of ?frame ;
        geom-rel:with-respect-to ?base .
    ?frame geom:origin ?origin .
    ?base geom:origin ?point .
    ?numbers geom-coord:of-pose ?pose ;
        geom-coord:x ?x ;
        geom-coord:y ?y ;
        geom-coord:z ?z ;
        kin:alpha|kin:qw ?turn .
    FILTER NOT EXISTS {
        ?numbers geom-coord:x|geom-coord:y|geom-coord:z|kin:alpha|kin:beta|kin:gamma|kin:qx|kin:qy|kin:qz ?number .
        FILTER (?number != 0)
    }
    FILTER NOT EXISTS { ?numbers kin:qw ?real . FILTER (ABS(?real) != 1) }
    FILTER NOT EXISTS { ?pose geom-rel:with-respect-to ?other . FILTER (?other != ?base) }
    # A joint of a body with itself keeps two attachments.
    FILTER NOT EXISTS { ?owner kin:parent-body ?body ; kin:child-body ?body }
} ;

# A frame that stands in a circle of such is replaced by none.

DELETE { ?frame ir:replaced-by ?base }
WHERE { ?frame ir:replaced-by ?base . ?base ir:replaced-by+ ?base } ;

# An inertia that is seen along the axes of its body needs no frame at the centre of mass, which has a position.

INSERT {
    ?frame ir:replaced-by ?base .
    ?position a geom-rel:Position ;
        geom-rel:of ?centre ;
        geom-rel:with-respect-to ?point ;
        qudt:hasQuantityKind quantitykind:Length .
    ?coordinates a geom-coord:PositionReference , geom-coord:PositionCoordinate , geom-coord:VectorXYZ ;
        geom-coord:of-position ?position ;
        geom-coord:as-seen-by ?base ;
        qudt:unit unit:M ;
        geom-coord:x ?x ;
        geom-coord:y ?y ;
        geom-coord:z ?z .
} WHERE {
    ?user dyn-coord:as-seen-by ?frame ;
        dyn-coord:of-inertia/dyn-ent:about ?centre .
    ?frame geom:origin ?centre .
    ?pose geom-rel:of ?frame ;
        geom-rel:with-respect-to ?base .
    ?base geom:origin ?point .
    ?numbers geom-coord:of-pose ?pose ;
        geom-coord:x ?x ;
        geom-coord:y ?y ;
        geom-coord:z ?z ;
        kin:alpha|kin:qw ?turn .
    FILTER NOT EXISTS { ?frame ir:replaced-by ?other }
    FILTER NOT EXISTS {
        ?numbers kin:alpha|kin:beta|kin:gamma|kin:qx|kin:qy|kin:qz ?number .
        FILTER (?number != 0)
    }
    FILTER NOT EXISTS { ?numbers kin:qw ?real . FILTER (ABS(?real) != 1) }
    BIND (IRI(CONCAT(STR(?centre), "/position")) AS ?position)
    BIND (IRI(CONCAT(STR(?centre), "/position/coordinates")) AS ?coordinates)
} ;

# The vectors of a frame that is replaced are those of the other.

INSERT { ?vector ir:replaced-by ?same }
WHERE {
    VALUES ?property { geom:vector-x geom:vector-y geom:vector-z }
    ?frame ir:replaced-by ?base ;
        ?property ?vector .
    ?base ?property ?same .
} ;

DELETE { ?gone ?property ?value }
WHERE {
    ?frame a geom:Frame ;
        ir:replaced-by ?base .
    ?gone geom-coord:of-pose?/geom-rel:of ?frame ;
        ?property ?value .
}
