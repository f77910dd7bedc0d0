# KDL has a constructor for any axis of each motion.

INSERT { ?joint gen:type ?type }
WHERE {
    VALUES (?motion ?type) {
        ("revolute" "RotAxis")
        ("prismatic" "TransAxis")
        ("fixed" "Fixed")
    }
    ?joint gen:motion ?motion .
}
