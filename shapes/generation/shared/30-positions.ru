# The positions that a program takes: those of the joints that move and follow no other.

INSERT { ?program gen:position ?joint }
WHERE {
    ?program gen:joint ?joint .
    ?joint gen:motion ?motion .
    FILTER (?motion != "fixed")
    FILTER NOT EXISTS { ?joint gen:leader ?leader }
}
