# Pinocchio has faster models of joints along a coordinate axis, and one for any other.

INSERT { ?joint gen:type ?type }
WHERE {
    VALUES (?motion ?x ?y ?z ?type) {
        ("revolute" 1 0 0 "JointModelRX")
        ("revolute" 0 1 0 "JointModelRY")
        ("revolute" 0 0 1 "JointModelRZ")
        ("prismatic" 1 0 0 "JointModelPX")
        ("prismatic" 0 1 0 "JointModelPY")
        ("prismatic" 0 0 1 "JointModelPZ")
    }
    ?joint gen:motion ?motion ;
        gen:axis ?axis .
    ?axis gen:x ?x1 ; gen:y ?y1 ; gen:z ?z1 .
    FILTER (?x1 = ?x && ?y1 = ?y && ?z1 = ?z)
} ;

INSERT { ?joint gen:type ?type ; gen:unaligned true }
WHERE {
    VALUES (?motion ?type) {
        ("revolute" "JointModelRevoluteUnaligned")
        ("prismatic" "JointModelPrismaticUnaligned")
    }
    ?joint gen:motion ?motion .
    FILTER NOT EXISTS { ?joint gen:type ?aligned }
}
