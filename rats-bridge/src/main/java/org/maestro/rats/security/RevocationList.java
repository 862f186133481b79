package org.maestro.rats.security;

import java.io.ByteArrayInputStream;
import java.math.BigInteger;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509CRL;
import java.security.cert.X509CRLEntry;
import java.security.cert.X509Certificate;
import java.util.Set;
import java.util.TreeSet;

/**
 * The certificates of a site that are taken back though they are still in date, by their numbers.
 * Immutable.
 */
record RevocationList(Set<BigInteger> numbers) {
  RevocationList {
    numbers = Set.copyOf(numbers);
  }

  static RevocationList none() {
    return new RevocationList(Set.of());
  }

  /**
   * @throws SecurityFilesException when it is missing, or not the authority's
   */
  static RevocationList read(Path file, X509Certificate authority) {
    byte[] bytes = PrivateFiles.bytes(file);
    try {
      X509CRL list =
          (X509CRL)
              CertificateFactory.getInstance("X.509").generateCRL(new ByteArrayInputStream(bytes));
      list.verify(authority.getPublicKey());
      Set<BigInteger> numbers = new TreeSet<>();
      if (list.getRevokedCertificates() != null) {
        for (X509CRLEntry entry : list.getRevokedCertificates()) {
          numbers.add(entry.getSerialNumber());
        }
      }
      return new RevocationList(numbers);
    } catch (GeneralSecurityException | ClassCastException broken) {
      throw new SecurityFilesException(
          "The security file %s is no list of the site's authority; make it anew with ./maestro secure"
              .formatted(file),
          broken);
    }
  }

  boolean holds(X509Certificate certificate) {
    return numbers.contains(certificate.getSerialNumber());
  }

  /** This one with others as well. */
  RevocationList and(Set<BigInteger> others) {
    Set<BigInteger> all = new TreeSet<>(numbers);
    all.addAll(others);
    return new RevocationList(all);
  }
}
