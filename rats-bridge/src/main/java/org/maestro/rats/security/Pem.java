package org.maestro.rats.security;

import java.io.ByteArrayInputStream;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.PrivateKey;
import java.security.cert.CertificateExpiredException;
import java.security.cert.CertificateFactory;
import java.security.cert.CertificateNotYetValidException;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.security.spec.PKCS8EncodedKeySpec;
import java.util.Base64;

/** Certificates and private keys (elliptic curves, PKCS 8) as PEM text. */
final class Pem {

  private static final String KEY = "PRIVATE KEY";
  private static final String CERTIFICATE = "CERTIFICATE";
  private static final String LIST = "X509 CRL";

  private Pem() {}

  static String of(X509Certificate certificate) throws GeneralSecurityException {
    return wrapped(CERTIFICATE, certificate.getEncoded());
  }

  static String of(X509CRL list) throws GeneralSecurityException {
    return wrapped(LIST, list.getEncoded());
  }

  static String of(PrivateKey key) {
    return wrapped(KEY, key.getEncoded());
  }

  /** One that is no longer, or not yet, valid would only keep everybody from connecting. */
  static X509Certificate certificate(Path file) {
    byte[] bytes = PrivateFiles.bytes(file);
    try {
      X509Certificate certificate =
          (X509Certificate)
              CertificateFactory.getInstance("X.509")
                  .generateCertificate(new ByteArrayInputStream(bytes));
      certificate.checkValidity();
      return certificate;
    } catch (CertificateExpiredException | CertificateNotYetValidException outOfTime) {
      throw new SecurityFilesException(
          "The certificate %s cannot be used today (%s); set the clock, or make the files of the site anew with ./maestro secure in another directory"
              .formatted(file, outOfTime.getMessage()),
          outOfTime);
    } catch (GeneralSecurityException | ClassCastException broken) {
      throw new SecurityFilesException(
          "The security file " + file + " holds no certificate; make it anew with ./maestro secure",
          broken);
    }
  }

  static PrivateKey key(Path file) {
    String text = PrivateFiles.secret(file);
    try {
      String body =
          text.replace("-----BEGIN " + KEY + "-----", "")
              .replace("-----END " + KEY + "-----", "")
              .replaceAll("\\s", "");
      return KeyFactory.getInstance("EC")
          .generatePrivate(new PKCS8EncodedKeySpec(Base64.getDecoder().decode(body)));
    } catch (GeneralSecurityException | IllegalArgumentException broken) {
      throw new SecurityFilesException(
          "The security file " + file + " holds no private key; make it anew with ./maestro secure",
          broken);
    }
  }

  private static String wrapped(String kind, byte[] bytes) {
    String body = Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(bytes);
    return "-----BEGIN %s-----%n%s%n-----END %s-----%n"
        .formatted(kind, body, kind)
        .replace(System.lineSeparator(), "\n");
  }
}
