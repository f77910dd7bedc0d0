# A joint that never moves has no offset beside its zero configuration, which says where both bodies are.

DELETE {
    ?joint kc:origin-offset ?offset .
    ?gone ?property ?value .
} WHERE {
    ?joint a kin:FixedJoint ;
        kc:origin-offset ?offset .
    ?zero a kin:ZeroConfiguration ;
        kin:of-joint ?joint .
    ?gone geom-coord:of-position? ?offset ;
        ?property ?value .
}
