# What is replaced is named nowhere any more, and nothing is said of it.

DELETE { ?user ?property ?replaced }
INSERT { ?user ?property ?last }
WHERE {
    ?replaced ir:replaced-by+ ?last .
    FILTER NOT EXISTS { ?last ir:replaced-by ?next }
    ?user ?property ?replaced .
    FILTER (?property != ir:replaced-by)
} ;

DELETE { ?replaced ?property ?value }
WHERE {
    ?replaced ir:replaced-by ?by ;
        ?property ?value .
}
