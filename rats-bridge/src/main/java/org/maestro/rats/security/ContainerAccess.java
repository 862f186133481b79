package org.maestro.rats.security;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.Signature;
import java.security.cert.X509Certificate;
import java.util.Optional;
import java.util.SortedSet;
import javax.naming.InvalidNameException;
import javax.naming.ldap.LdapName;
import javax.net.ssl.SSLContext;

/**
 * The credentials by which a process can be a container of a secured site's platform: its own
 * certificate, by which it speaks TLS and signs, and the token that all containers of the site
 * share. Immutable.
 */
public final class ContainerAccess {
  private static final String ALGORITHM = "SHA256withECDSA";

  private final String user;
  private final SortedSet<String> containers;
  private final SortedSet<String> guests;
  private final X509Certificate authority;
  private final RevocationList revoked;
  private final CertificateAuthority.Identity identity;
  private final SSLContext tls;
  private final byte[] token;

  ContainerAccess(
      String user,
      SortedSet<String> containers,
      SortedSet<String> guests,
      X509Certificate authority,
      RevocationList revoked,
      CertificateAuthority.Identity identity,
      SSLContext tls,
      String token) {
    this.user = user;
    this.containers = containers;
    this.guests = guests;
    this.authority = authority;
    this.revoked = revoked;
    this.identity = identity;
    this.tls = tls;
    this.token = token.getBytes(UTF_8);
    if (!isSigned(this.token, sign(this.token), identity.certificate())) {
      throw new SecurityFilesException(
          "The key and the certificate of the user %s do not belong together; have both made anew with ./maestro secure --renew %s"
              .formatted(user, user));
    }
  }

  /** The user whose process it is. */
  public String user() {
    return user;
  }

  /** Whether the user may only ask, and is not known to the bus. */
  public boolean isGuest(String other) {
    return guests.contains(other);
  }

  /** Shows the own certificate, and trusts those of the site only. */
  public SSLContext tls() {
    return tls;
  }

  public X509Certificate certificate() {
    return identity.certificate();
  }

  public byte[] token() {
    return token.clone();
  }

  /** Whether it is the site's token; takes as long for a wrong one as for the right one. */
  public boolean isToken(byte[] other) {
    return MessageDigest.isEqual(token, other);
  }

  public byte[] sign(byte[] text) {
    try {
      Signature signature = Signature.getInstance(ALGORITHM);
      signature.initSign(identity.key());
      signature.update(text);
      return signature.sign();
    } catch (GeneralSecurityException unable) {
      throw new SecurityFilesException(
          "The key of the user " + user + " cannot sign: " + unable.getMessage(), unable);
    }
  }

  /** Whether the text was signed with the certificate's key. */
  public static boolean isSigned(byte[] text, byte[] signature, X509Certificate certificate) {
    try {
      Signature check = Signature.getInstance(ALGORITHM);
      check.initVerify(certificate.getPublicKey());
      check.update(text);
      return check.verify(signature);
    } catch (GeneralSecurityException none) {
      return false;
    }
  }

  /**
   * The user of whom the certificate is.
   *
   * @return empty unless the site has issued it to a container and not taken it back, and it is in
   *     date
   */
  public Optional<String> holder(X509Certificate certificate) {
    try {
      certificate.verify(authority.getPublicKey());
      certificate.checkValidity();
      return Optional.of(commonName(certificate))
          .filter(name -> containers.contains(name) && !revoked.holds(certificate));
    } catch (GeneralSecurityException | InvalidNameException notOfTheSite) {
      return Optional.empty();
    }
  }

  private static String commonName(X509Certificate certificate) throws InvalidNameException {
    return new LdapName(certificate.getSubjectX500Principal().getName())
        .getRdns().stream()
            .filter(part -> part.getType().equalsIgnoreCase("CN"))
            .map(part -> part.getValue().toString())
            .findFirst()
            .orElse("");
  }
}
