"""URI schemes that may stand before a colon without being a prefix (IANA's registry, in part)."""

from __future__ import annotations

REGISTERED = frozenset(
    """
    about acct acr admin afp afs aim amss android app appdata attachment bb bitcoin blob bolo
    cap cast chrome chrome-extension cid coap coap+tcp coap+ws coaps coaps+tcp coaps+ws content
    crid cvs dab dat data dav dhttp diaspora dict did dns doi drm dtn ed2k example facetime fax
    feed file filesystem fish ftp ftps geo git git+https git+ssh gizmoproject go gopher gtalk
    h323 ham hcp http https hxxp hxxps iax icap icon im imap info iotdisco ipfs ipn ipns ipp ipps
    irc irc6 ircs iris isbn isostore itms jabber jar jdbc jms keyparc lastfm ldap ldaps lpa
    magnet mailserver mailto maps market matrix message mid mms modem mqtt mqtts ms-settings
    msnim msrp msrps mtqp mumble mupdate mvn news nfs ni nih nntp notes oid opaquelocktoken
    openid orcid package pack palm paparazzi payto pkcs11 platform pop pres prospero proxy
    psyc pwid query redis rediss reload resource rmi rsync rtmp rtsp rtsps rtspu secondlife
    service session sftp sgn shttp sieve sip sips skype smb sms smtp snews snmp soap.beep
    soldat spotify ssh steam stun stuns submit svn svn+ssh swid tag teamspeak tel telnet tftp
    things thismessage tip tn3270 tool turn turns tv udp unreal urn ut2004 uuid-in-package
    vemmi vnc view-source wais webcal ws wss wtai wyciwyg xcon xfire xmlrpc.beep xmpp xri
    z39.50 z39.50r z39.50s model
    """.split()  # noqa: SIM905  nobody reads a column of 250 lines
)
"""Lower-case names, and `model:` and `package:`, which simulators and ROS made customary."""
