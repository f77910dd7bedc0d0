# The axes of a frame as another sees them, to 15 decimals: from roll, pitch and yaw about fixed axes, and
# from a quaternion of any length but zero. Two rotations of one frame are left.
#
# Source: Shuster, A Survey of Attitude Representations, 1993.

DELETE {
    ?numbers a kin:EulerAngles , kin:Extrinsic , kin:Quaternion ;
        qudt:unit ?unit ;
        kin:axes-sequence ?sequence ;
        kin:alpha ?alpha ; kin:beta ?beta ; kin:gamma ?gamma ;
        kin:qx ?qx ; kin:qy ?qy ; kin:qz ?qz ; kin:qw ?qw .
} INSERT {
    ?numbers a geom-coord:DirectionCosineXYZ ;
        qudt:unit unit:UNITLESS ;
        geom-coord:direction-cosine-x (?xx ?xy ?xz) ;
        geom-coord:direction-cosine-y (?yx ?yy ?yz) ;
        geom-coord:direction-cosine-z (?zx ?zy ?zz) .
} WHERE {
    FILTER NOT EXISTS { ?numbers a kin:Quaternion , kin:EulerAngles }
    {
        ?numbers a kin:EulerAngles ;
            qudt:unit ?unit ;
            kin:axes-sequence ?sequence ;
            kin:alpha ?alpha ;
            kin:beta ?beta ;
            kin:gamma ?gamma .
        FILTER (?unit IN (unit:RAD, unit:DEG))
        BIND (IF(?unit = unit:DEG, math:pi() / 180, 1.0e0) AS ?radians)
        BIND (math:cos(?radians * ?alpha) AS ?ca)
        BIND (math:sin(?radians * ?alpha) AS ?sa)
        BIND (math:cos(?radians * ?beta) AS ?cb)
        BIND (math:sin(?radians * ?beta) AS ?sb)
        BIND (math:cos(?radians * ?gamma) AS ?cg)
        BIND (math:sin(?radians * ?gamma) AS ?sg)
        BIND (?cb * ?cg AS ?m11)
        BIND (?cb * ?sg AS ?m21)
        BIND (0 - ?sb AS ?m31)
        BIND (?sa * ?sb * ?cg - ?ca * ?sg AS ?m12)
        BIND (?sa * ?sb * ?sg + ?ca * ?cg AS ?m22)
        BIND (?sa * ?cb AS ?m32)
        BIND (?ca * ?sb * ?cg + ?sa * ?sg AS ?m13)
        BIND (?ca * ?sb * ?sg - ?sa * ?cg AS ?m23)
        BIND (?ca * ?cb AS ?m33)
    } UNION {
        ?numbers a kin:Quaternion ;
            kin:qx ?qx ;
            kin:qy ?qy ;
            kin:qz ?qz ;
            kin:qw ?qw .
        BIND (?qx * ?qx + ?qy * ?qy + ?qz * ?qz + ?qw * ?qw AS ?square)
        FILTER (?square > 0)
        BIND (2 / ?square AS ?twice)
        BIND (1 - ?twice * (?qy * ?qy + ?qz * ?qz) AS ?m11)
        BIND (?twice * (?qx * ?qy + ?qz * ?qw) AS ?m21)
        BIND (?twice * (?qx * ?qz - ?qy * ?qw) AS ?m31)
        BIND (?twice * (?qx * ?qy - ?qz * ?qw) AS ?m12)
        BIND (1 - ?twice * (?qx * ?qx + ?qz * ?qz) AS ?m22)
        BIND (?twice * (?qy * ?qz + ?qx * ?qw) AS ?m32)
        BIND (?twice * (?qx * ?qz + ?qy * ?qw) AS ?m13)
        BIND (?twice * (?qy * ?qz - ?qx * ?qw) AS ?m23)
        BIND (1 - ?twice * (?qx * ?qx + ?qy * ?qy) AS ?m33)
    }
    BIND (ROUND(1e15 * ?m11) / 1e15 + 0 AS ?xx)
    BIND (ROUND(1e15 * ?m21) / 1e15 + 0 AS ?xy)
    BIND (ROUND(1e15 * ?m31) / 1e15 + 0 AS ?xz)
    BIND (ROUND(1e15 * ?m12) / 1e15 + 0 AS ?yx)
    BIND (ROUND(1e15 * ?m22) / 1e15 + 0 AS ?yy)
    BIND (ROUND(1e15 * ?m32) / 1e15 + 0 AS ?yz)
    BIND (ROUND(1e15 * ?m13) / 1e15 + 0 AS ?zx)
    BIND (ROUND(1e15 * ?m23) / 1e15 + 0 AS ?zy)
    BIND (ROUND(1e15 * ?m33) / 1e15 + 0 AS ?zz)
}
