# The pose of a model in its world, by which the models of a world are placed: the world is a body with a frame.

INSERT {
    ?ground a geom:RigidBody , geom:SimplicialComplex ;
        geom:simplices ?base , ?point .
    ?base a geom:Frame , geom:Orthonormal , geom:RightHanded ;
        geom:origin ?point .
    ?point a geom:Point .
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
        qudt:unit ?angle ;
        kin:alpha ?roll ;
        kin:beta ?pitch ;
        kin:gamma ?yaw .
} WHERE {
    GRAPH ?said {
        ?file sdf:world ?world .
        ?world sdf:model ?model .
        ?model src:attachedTo ?link .
        FILTER EXISTS { ?world sdf:model ?other . FILTER (?other != ?model) }
        FILTER NOT EXISTS { ?model at:placement_frame ?placed }
        OPTIONAL {
            ?model sdf:pose ?place .
            ?place src:text-1 ?n1 ; src:text-2 ?n2 ; src:text-3 ?n3 ;
                src:text-4 ?n4 ; src:text-5 ?n5 ; src:text-6 ?n6 .
            FILTER NOT EXISTS { ?place src:text-7 ?quaternion }
            FILTER NOT EXISTS { ?place ref:relative_to|at:relative_to ?seen }
            OPTIONAL { ?place at:degrees ?degrees }
        }
        FILTER (BOUND(?n6) || NOT EXISTS { ?model sdf:pose ?unread })
    }
    BIND (REPLACE(STR(?model), "#/", "#") AS ?own)
    BIND (REPLACE(STR(?world), "#/", "#") AS ?around)
    BIND (IRI(CONCAT(?own, "/frame")) AS ?frame)
    BIND (IRI(CONCAT(?own, "/placement")) AS ?pose)
    BIND (IRI(CONCAT(?own, "/placement/position")) AS ?position)
    BIND (IRI(CONCAT(?own, "/placement/orientation")) AS ?orientation)
    BIND (IRI(?around) AS ?ground)
    BIND (IRI(CONCAT(?around, "/frame")) AS ?base)
    BIND (IRI(CONCAT(?around, "/frame/origin")) AS ?point)
    ?frame a geom:Frame .
    FILTER NOT EXISTS { ?pose geom-rel:of ?known }
    BIND (IF(BOUND(?degrees) && ?degrees, unit:DEG, unit:RAD) AS ?angle)
    BIND (COALESCE(?n1, "0"^^xsd:double) AS ?x)
    BIND (COALESCE(?n2, "0"^^xsd:double) AS ?y)
    BIND (COALESCE(?n3, "0"^^xsd:double) AS ?z)
    BIND (COALESCE(?n4, "0"^^xsd:double) AS ?roll)
    BIND (COALESCE(?n5, "0"^^xsd:double) AS ?pitch)
    BIND (COALESCE(?n6, "0"^^xsd:double) AS ?yaw)
}
