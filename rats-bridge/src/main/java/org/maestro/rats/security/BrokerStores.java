package org.maestro.rats.security;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;

/** Key stores as Artemis reads them. */
final class BrokerStores {

  private BrokerStores() {}

  /** What the broker shows. */
  static byte[] own(
      String password, CertificateAuthority.Identity identity, Certificate authority) {
    return written(
        password,
        store ->
            store.setKeyEntry(
                "broker",
                identity.key(),
                password.toCharArray(),
                new Certificate[] {identity.certificate(), authority}));
  }

  /** Whom it believes. */
  static byte[] trusted(String password, Certificate authority) {
    return written(password, store -> store.setCertificateEntry("site", authority));
  }

  private interface Content {
    void putInto(KeyStore store) throws GeneralSecurityException;
  }

  private static byte[] written(String password, Content content) {
    try {
      KeyStore store = KeyStore.getInstance("PKCS12");
      store.load(null, null);
      content.putInto(store);
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      store.store(bytes, password.toCharArray());
      return bytes.toByteArray();
    } catch (GeneralSecurityException | IOException unable) {
      throw new SecurityFilesException("This Java cannot write key stores.", unable);
    }
  }
}
