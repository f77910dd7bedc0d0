# A rotation as roll, pitch and yaw in radians about fixed axes, from a quaternion of any length but zero.
# Where the pitch is a quarter turn, only the sum or the difference of the others is known: the yaw is zero.
#
# Source: Diebel, Representing Attitude, 2006, section 8.11.

DELETE {
    ?numbers a kin:Quaternion ;
        qudt:unit unit:UNITLESS ;
        kin:qx ?qx ; kin:qy ?qy ; kin:qz ?qz ; kin:qw ?qw .
} INSERT {
    ?numbers a kin:EulerAngles , kin:Extrinsic ;
        qudt:unit unit:RAD ;
        kin:axes-sequence "xyz" ;
        kin:alpha ?roll ;
        kin:beta ?pitch ;
        kin:gamma ?yaw .
} WHERE {
    FILTER NOT EXISTS { ?numbers a kin:Quaternion , kin:EulerAngles }
    ?numbers a kin:Quaternion ;
        kin:qx ?qx ;
        kin:qy ?qy ;
        kin:qz ?qz ;
        kin:qw ?qw .
    BIND (?qx * ?qx + ?qy * ?qy + ?qz * ?qz + ?qw * ?qw AS ?square)
    FILTER (?square > 0)
    BIND (2 / ?square AS ?twice)
    BIND (?twice * (?qx * ?qz - ?qy * ?qw) AS ?m31)
    BIND (?twice * (?qy * ?qz + ?qx * ?qw) AS ?m32)
    BIND (1 - ?twice * (?qx * ?qx + ?qy * ?qy) AS ?m33)
    BIND (1 - ?twice * (?qy * ?qy + ?qz * ?qz) AS ?m11)
    BIND (?twice * (?qx * ?qy + ?qz * ?qw) AS ?m21)
    BIND (math:sqrt(?m32 * ?m32 + ?m33 * ?m33) AS ?cosine)
    BIND (?cosine < 1e-12 AS ?locked)
    BIND (math:atan2(0 - ?m31, ?cosine) AS ?pitch)
    BIND (IF(?locked, 2 * math:atan2(?qx, ?qw), math:atan2(?m32, ?m33)) AS ?roll)
    BIND (IF(?locked, 0.0e0, math:atan2(?m21, ?m11)) AS ?yaw)
}
