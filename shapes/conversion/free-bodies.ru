# The pose of a link of SDF that no joint moves or carries, or of a model whose canonical link is such, seen
# from the model that it is in or what it is relative to; else nothing would say where the body is.

INSERT {
    ?pose a geom-rel:Pose ;
        geom-rel:of ?frame ;
        geom-rel:with-respect-to ?base ;
        qudt:hasQuantityKind quantitykind:Angle , quantitykind:Length .
    ?position a geom-coord:PoseReference , geom-coord:PoseCoordinate , geom-coord:VectorXYZ ;
        geom-coord:of-pose ?pose ;
        geom-coord:as-seen-by ?base ;
        qudt:unit unit:M ;
        geom-coord:x ?x ;
        geom-coord:y ?y ;
        geom-coord:z ?z .
    ?orientation a geom-coord:PoseReference , geom-coord:PoseCoordinate , kin:EulerAngles , kin:Extrinsic ;
        geom-coord:of-pose ?pose ;
        geom-coord:as-seen-by ?base ;
        kin:axes-sequence "xyz" ;
        qudt:unit unit:RAD ;
        kin:alpha ?roll ;
        kin:beta ?pitch ;
        kin:gamma ?yaw .
} WHERE {
    GRAPH ?said {
        { ?model sdf:link ?link . BIND (?link AS ?free) BIND ("/pose" AS ?relation) }
        # Its own pose is that of its frame on its canonical link.
        UNION { ?model sdf:model ?link . ?link src:attachedTo ?free . BIND ("/placement" AS ?relation) }
        # The canonical link is free, and the frame of the model on it: the others are seen from there.
        UNION {
            ?model ?word ?link ; src:attachedTo ?free .
            FILTER (?word IN (sdf:link, sdf:model) && ?link != ?free)
            FILTER NOT EXISTS { ?holding src:childBody ?link }
            BIND (IF(?word = sdf:link, "/pose", "/placement") AS ?relation)
        }
        ?link src:scope ?scope .
        OPTIONAL {
            ?link sdf:pose ?place .
            ?place src:text-1 ?n1 ; src:text-2 ?n2 ; src:text-3 ?n3 ;
                src:text-4 ?n4 ; src:text-5 ?n5 ; src:text-6 ?n6 .
            FILTER NOT EXISTS { ?place src:text-7 ?quaternion }
            OPTIONAL { ?place ref:relative_to ?seen }
            FILTER NOT EXISTS { ?place at:degrees ?degrees }
        }
        FILTER (BOUND(?n6) || NOT EXISTS { ?link sdf:pose ?unread })
        FILTER NOT EXISTS { ?joint src:parentBody|src:childBody ?free }
    }
    BIND (COALESCE(?seen, ?model) AS ?from)
    # A joint without a pose is where its child is.
    OPTIONAL { GRAPH ?said { ?from src:childBody ?child } }
    BIND (IRI(CONCAT(REPLACE(STR(?from), "#/", "#"), "/child-frame")) AS ?hinge)
    BIND (IF(!BOUND(?child), ?from, IF(EXISTS { ?hinge a geom:Frame }, ?none, ?child)) AS ?holder)
    BIND (COALESCE(IRI(CONCAT(REPLACE(STR(?holder), "#/", "#"), "/frame")), ?hinge) AS ?base)
    BIND (REPLACE(STR(?link), "#/", "#") AS ?body)
    BIND (IRI(CONCAT(?body, "/frame")) AS ?frame)
    BIND (IRI(CONCAT(?body, ?relation)) AS ?pose)
    BIND (IRI(CONCAT(?body, ?relation, "/position")) AS ?position)
    BIND (IRI(CONCAT(?body, ?relation, "/orientation")) AS ?orientation)
    ?frame a geom:Frame .
    ?base a geom:Frame .
    # The frame of a model lies on its canonical link.
    ?carrier geom:simplices ?base .
    FILTER NOT EXISTS { ?carrier geom:simplices ?frame }
    FILTER NOT EXISTS {
        ?known a geom-rel:Pose ; geom-rel:of ?frame ; geom-rel:with-respect-to ?there .
        ?bearer geom:simplices ?there .
        FILTER NOT EXISTS { ?bearer geom:simplices ?frame }
    }
    FILTER NOT EXISTS { ?pose geom-rel:of ?other }
    BIND (COALESCE(?n1, "0"^^xsd:double) AS ?x)
    BIND (COALESCE(?n2, "0"^^xsd:double) AS ?y)
    BIND (COALESCE(?n3, "0"^^xsd:double) AS ?z)
    BIND (COALESCE(?n4, "0"^^xsd:double) AS ?roll)
    BIND (COALESCE(?n5, "0"^^xsd:double) AS ?pitch)
    BIND (COALESCE(?n6, "0"^^xsd:double) AS ?yaw)
}
