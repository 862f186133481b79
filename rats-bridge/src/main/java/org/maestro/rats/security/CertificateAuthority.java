package org.maestro.rats.security;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.PrivateKey;
import java.security.SecureRandom;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.security.spec.ECGenParameterSpec;
import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.Date;
import java.util.List;
import org.bouncycastle.asn1.x500.X500Name;
import org.bouncycastle.asn1.x500.X500NameBuilder;
import org.bouncycastle.asn1.x500.style.BCStyle;
import org.bouncycastle.asn1.x509.BasicConstraints;
import org.bouncycastle.asn1.x509.ExtendedKeyUsage;
import org.bouncycastle.asn1.x509.Extension;
import org.bouncycastle.asn1.x509.GeneralName;
import org.bouncycastle.asn1.x509.GeneralNames;
import org.bouncycastle.asn1.x509.KeyPurposeId;
import org.bouncycastle.asn1.x509.KeyUsage;
import org.bouncycastle.cert.X509v2CRLBuilder;
import org.bouncycastle.cert.X509v3CertificateBuilder;
import org.bouncycastle.cert.jcajce.JcaX509CRLConverter;
import org.bouncycastle.cert.jcajce.JcaX509CertificateConverter;
import org.bouncycastle.cert.jcajce.JcaX509ExtensionUtils;
import org.bouncycastle.cert.jcajce.JcaX509v3CertificateBuilder;
import org.bouncycastle.operator.OperatorCreationException;
import org.bouncycastle.operator.jcajce.JcaContentSignerBuilder;

/** A site's own certificate authority, which signs its broker's and its users' certificates. */
final class CertificateAuthority {

  private static final Duration LIFE = Duration.ofDays(3650);
  private static final Duration CLOCKS_DIFFER_BY = Duration.ofDays(1);
  private static final int SERIAL_BITS = 120;
  private static final int NO_REASON = 0;
  private static final String ALGORITHM = "SHA256withECDSA";
  private static final SecureRandom RANDOM = new SecureRandom();

  /** A certificate with the key that it belongs to. */
  record Identity(X509Certificate certificate, PrivateKey key) {}

  private interface Extensions {
    void add(X509v3CertificateBuilder builder, JcaX509ExtensionUtils utils, KeyPair keys)
        throws IOException, GeneralSecurityException;
  }

  private final X509Certificate certificate;
  private final PrivateKey key;

  private CertificateAuthority(X509Certificate certificate, PrivateKey key) {
    this.certificate = certificate;
    this.key = key;
  }

  static CertificateAuthority make(String site) {
    KeyPair keys = keys();
    X500Name name = name("RATS site " + site);
    X509Certificate certificate =
        signed(
            name,
            keys.getPrivate(),
            name,
            keys,
            (builder, utils, own) -> {
              builder.addExtension(Extension.basicConstraints, true, new BasicConstraints(0));
              builder.addExtension(
                  Extension.keyUsage, true, new KeyUsage(KeyUsage.keyCertSign | KeyUsage.cRLSign));
              builder.addExtension(
                  Extension.subjectKeyIdentifier,
                  false,
                  utils.createSubjectKeyIdentifier(own.getPublic()));
            });
    return new CertificateAuthority(certificate, keys.getPrivate());
  }

  static CertificateAuthority read(Path certificate, Path key) {
    return new CertificateAuthority(Pem.certificate(certificate), Pem.key(key));
  }

  X509Certificate certificate() {
    return certificate;
  }

  PrivateKey key() {
    return key;
  }

  /**
   * @param hosts names and addresses that the broker is reached by
   */
  Identity broker(Collection<String> hosts) {
    GeneralName[] names =
        hosts.stream().map(CertificateAuthority::host).toArray(GeneralName[]::new);
    return issued(
        hosts.iterator().next(),
        List.of(new NamedExtension(new GeneralNames(names))),
        KeyPurposeId.id_kp_serverAuth);
  }

  Identity user(String id) {
    return issued(id, List.of(), KeyPurposeId.id_kp_clientAuth);
  }

  /** Of a container, which calls others and is called by them. */
  Identity container(String id) {
    return issued(id, List.of(), KeyPurposeId.id_kp_clientAuth, KeyPurposeId.id_kp_serverAuth);
  }

  /** In the form in which brokers read it, too. */
  X509CRL revoking(RevocationList list) {
    Instant now = Instant.now();
    X509v2CRLBuilder builder =
        new X509v2CRLBuilder(own(), Date.from(now.minus(CLOCKS_DIFFER_BY)))
            .setNextUpdate(Date.from(now.plus(LIFE)));
    list.numbers().forEach(number -> builder.addCRLEntry(number, Date.from(now), NO_REASON));
    try {
      return new JcaX509CRLConverter()
          .getCRL(builder.build(new JcaContentSignerBuilder(ALGORITHM).build(key)));
    } catch (GeneralSecurityException | OperatorCreationException unable) {
      throw new SecurityFilesException(
          "This Java cannot take certificates back: " + unable.getMessage(), unable);
    }
  }

  private X500Name own() {
    return X500Name.getInstance(certificate.getSubjectX500Principal().getEncoded());
  }

  private record NamedExtension(GeneralNames names) {}

  private Identity issued(String name, List<NamedExtension> names, KeyPurposeId... purposes) {
    KeyPair keys = keys();
    X509Certificate issued =
        signed(
            own(),
            key,
            name(name),
            keys,
            (builder, utils, own) -> {
              builder.addExtension(Extension.basicConstraints, true, new BasicConstraints(false));
              builder.addExtension(
                  Extension.keyUsage, true, new KeyUsage(KeyUsage.digitalSignature));
              builder.addExtension(
                  Extension.extendedKeyUsage, false, new ExtendedKeyUsage(purposes));
              builder.addExtension(
                  Extension.authorityKeyIdentifier,
                  false,
                  utils.createAuthorityKeyIdentifier(certificate));
              for (NamedExtension also : names) {
                builder.addExtension(Extension.subjectAlternativeName, false, also.names());
              }
            });
    return new Identity(issued, keys.getPrivate());
  }

  private static X509Certificate signed(
      X500Name issuer,
      PrivateKey issuerKey,
      X500Name subject,
      KeyPair keys,
      Extensions extensions) {
    Instant now = Instant.now();
    X509v3CertificateBuilder builder =
        new JcaX509v3CertificateBuilder(
            issuer,
            new BigInteger(SERIAL_BITS, RANDOM).add(BigInteger.ONE),
            Date.from(now.minus(CLOCKS_DIFFER_BY)),
            Date.from(now.plus(LIFE)),
            subject,
            keys.getPublic());
    try {
      extensions.add(builder, new JcaX509ExtensionUtils(), keys);
      return new JcaX509CertificateConverter()
          .getCertificate(builder.build(new JcaContentSignerBuilder(ALGORITHM).build(issuerKey)));
    } catch (IOException | GeneralSecurityException | OperatorCreationException unable) {
      throw new SecurityFilesException(
          "This Java cannot make certificates: " + unable.getMessage(), unable);
    }
  }

  private static KeyPair keys() {
    try {
      KeyPairGenerator generator = KeyPairGenerator.getInstance("EC");
      generator.initialize(new ECGenParameterSpec("secp256r1"), RANDOM);
      return generator.generateKeyPair();
    } catch (GeneralSecurityException unable) {
      throw new SecurityFilesException("This Java knows no elliptic curves.", unable);
    }
  }

  private static X500Name name(String text) {
    return new X500NameBuilder().addRDN(BCStyle.CN, text).build();
  }

  private static GeneralName host(String host) {
    boolean address = host.contains(":") || host.matches("[0-9]{1,3}(\\.[0-9]{1,3}){3}");
    return new GeneralName(address ? GeneralName.iPAddress : GeneralName.dNSName, host);
  }
}
