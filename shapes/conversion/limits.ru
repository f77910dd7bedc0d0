# A magnitude of effort, speed or acceleration limits both directions.

INSERT { ?limit kin:lower ?lower }
WHERE {
    ?limit kin:of-actuator ?actuator ;
        kin:upper ?upper .
    FILTER (?upper >= 0)
    FILTER NOT EXISTS { ?limit kin:lower ?written }
    BIND (0.0e0 - ?upper AS ?lower)
}
