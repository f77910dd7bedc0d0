# Nothing is said of the pose of what is not lifted, such as a sensor.

DELETE { ?gone ?property ?value }
WHERE {
    ?pose a geom-rel:Pose ;
        geom-rel:of ?frame .
    FILTER NOT EXISTS { ?frame a ?kind }
    ?gone geom-coord:of-pose? ?pose ;
        ?property ?value .
} ;

# The one root of a URDF, if it has no mass, stands still, and needs no inertia, nor the frame that sees it.

INSERT {
    ?inertia ir:replaced-by ?body .
    ?frame ir:replaced-by ?base .
    ?centre ir:replaced-by ?point .
} WHERE {
    ?inertia dyn-ent:of-body ?body ;
        dyn-ent:about ?centre .
    FILTER (REGEX(STR(?body), "#link/[^/]*$"))
    ?numbers dyn-coord:of-inertia ?inertia ;
        dyn-coord:mass ?mass ;
        dyn-coord:as-seen-by ?frame .
    FILTER (?mass = 0)
    FILTER NOT EXISTS { ?joint kin:child-body ?body }
    FILTER NOT EXISTS { ?weld a kin:FixedJoint ; kin:parent-body ?body }
    FILTER NOT EXISTS {
        ?other a geom:RigidBody .
        FILTER (?other != ?body)
        FILTER NOT EXISTS { ?carrying kin:child-body ?other }
    }
    ?pose geom-rel:of ?frame ;
        geom-rel:with-respect-to ?base .
    ?base geom:origin ?point .
} ;

DELETE { ?gone ?property ?value }
WHERE {
    ?inertia ir:replaced-by ?body ;
        dyn-ent:of-body ?body .
    ?gone dyn-coord:of-inertia? ?inertia ;
        ?property ?value .
}
