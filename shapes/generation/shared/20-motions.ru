# The kinds of joints whose motion is one number, or none.

INSERT { ?joint gen:motion ?motion }
WHERE {
    VALUES (?kind ?motion) {
        (kc:RevoluteJoint "revolute")
        (kin:PrismaticJoint "prismatic")
        (kin:FixedJoint "fixed")
    }
    ?program gen:joint ?joint .
    ?joint a ?kind .
}
