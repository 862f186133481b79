package org.maestro.rats.security;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.Certificate;
import java.security.cert.X509Certificate;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;

/**
 * Makes a site's security files, and adds users to them: what is there already (authority,
 * passwords, certificates, rules) stays as it is.
 */
public final class SecureSite {

  private final Path directory;

  private SecureSite(Path directory) {
    this.directory = directory;
  }

  /** Makes the files of a site without guests. */
  public static SiteUsers make(
      Path directory,
      String site,
      List<String> hosts,
      Collection<String> controllers,
      Collection<String> members) {
    return make(directory, site, hosts, controllers, members, List.of());
  }

  /**
   * Writes all files below the directory, each for its owner only.
   *
   * @param site its name on the bus
   * @param hosts names and addresses that the broker is reached by
   * @param guests who may join the platform and ask there, without being on the bus
   * @return everybody who belongs to the site now
   * @throws SecurityFilesException when a file cannot be written, or a name cannot be one
   */
  public static SiteUsers make(
      Path directory,
      String site,
      List<String> hosts,
      Collection<String> controllers,
      Collection<String> members,
      Collection<String> guests) {
    SecureSite secure = new SecureSite(directory.toAbsolutePath().normalize());
    return secure.make(
        new SiteUsers(
            site,
            hosts,
            new TreeSet<>(controllers),
            new TreeSet<>(members),
            new TreeSet<>(guests)));
  }

  private SiteUsers make(SiteUsers wanted) {
    SiteUsers users = wanted;
    Path file = directory.resolve(SiteSecurity.USERS);
    if (Files.exists(file)) {
      SiteUsers former = SiteUsers.parse(PrivateFiles.text(file), file.toString());
      if (!former.site().equals(wanted.site())) {
        throw new SecurityFilesException(
            "%s is of the site %s; choose another directory for the site %s"
                .formatted(directory, former.site(), wanted.site()));
      }
      users = wanted.and(former);
    }
    PrivateFiles.directory(directory);
    CertificateAuthority authority = authority(users.site());
    Map<String, String> passwords = new LinkedHashMap<>();
    for (String id : users.all()) {
      passwords.put(id, user(id, authority));
    }
    String token = token();
    for (String id : users.containers()) {
      container(id, authority, token);
    }
    String storePassword = broker(users, authority);
    new MosquittoFiles(users, directory).texts(passwords).forEach(this::write);
    new ArtemisFiles(users, directory).texts(passwords, storePassword).forEach(this::write);
    if (!Files.exists(directory.resolve(SiteSecurity.RULES))) {
      write(SiteSecurity.RULES, CallRules.USUAL);
    }
    write(SiteSecurity.USERS, users.text());
    return users;
  }

  private CertificateAuthority authority(String site) {
    Path certificate = directory.resolve(SiteSecurity.AUTHORITY);
    Path key = directory.resolve("ca/key.pem");
    if (Files.exists(certificate)) {
      return CertificateAuthority.read(certificate, key);
    }
    CertificateAuthority made = CertificateAuthority.make(site);
    PrivateFiles.write(key, Pem.of(made.key()));
    PrivateFiles.write(certificate, pem(made.certificate()));
    return made;
  }

  /** Returns the password. */
  private String user(String id, CertificateAuthority authority) {
    String own = SiteSecurity.ofUser(id);
    Path password = directory.resolve(own + SiteSecurity.PASSWORD);
    if (!Files.exists(password)) {
      CertificateAuthority.Identity identity = authority.user(id);
      write(own + SiteSecurity.KEY, Pem.of(identity.key()));
      write(own + SiteSecurity.CERTIFICATE, pem(identity.certificate()));
      write(own + "ca.pem", pem(authority.certificate()));
      PrivateFiles.write(password, PasswordHashes.newPassword() + "\n");
    }
    return PrivateFiles.secret(password).strip();
  }

  /** The site's own, made once: to have another one, remove its file and make the site again. */
  private String token() {
    Path file = directory.resolve(SiteSecurity.TOKEN);
    if (!Files.exists(file)) {
      PrivateFiles.write(file, PasswordHashes.newPassword() + "\n");
    }
    return PrivateFiles.secret(file);
  }

  private void container(String id, CertificateAuthority authority, String token) {
    String own = SiteSecurity.ofUser(id);
    if (!Files.exists(directory.resolve(own + SiteSecurity.CONTAINER_CERTIFICATE))) {
      CertificateAuthority.Identity identity = authority.container(id);
      write(own + SiteSecurity.CONTAINER_KEY, Pem.of(identity.key()));
      write(own + SiteSecurity.CONTAINER_CERTIFICATE, pem(identity.certificate()));
      write(own + "ca.pem", pem(authority.certificate()));
    }
    write(own + SiteSecurity.TOKEN, token);
  }

  /** Anew each time, as the hosts may be others; returns the password of the key stores. */
  private String broker(SiteUsers users, CertificateAuthority authority) {
    CertificateAuthority.Identity identity = authority.broker(users.hosts());
    write("broker/certificate.pem", pem(identity.certificate()));
    write("broker/key.pem", Pem.of(identity.key()));
    String storePassword = PasswordHashes.newPassword();
    PrivateFiles.write(
        directory.resolve("broker/broker.p12"),
        store(storePassword, identity.key(), identity.certificate(), authority.certificate()));
    PrivateFiles.write(
        directory.resolve("broker/trust.p12"), trust(storePassword, authority.certificate()));
    return storePassword;
  }

  private void write(String name, String text) {
    PrivateFiles.write(directory.resolve(name), text);
  }

  private static String pem(X509Certificate certificate) {
    try {
      return Pem.of(certificate);
    } catch (GeneralSecurityException unable) {
      throw unable(unable);
    }
  }

  private static byte[] store(String password, PrivateKey key, Certificate... chain) {
    try {
      KeyStore store = KeyStore.getInstance("PKCS12");
      store.load(null, null);
      store.setKeyEntry("broker", key, password.toCharArray(), chain);
      return bytes(store, password);
    } catch (GeneralSecurityException | IOException unable) {
      throw unable(unable);
    }
  }

  private static byte[] trust(String password, Certificate authority) {
    try {
      KeyStore store = KeyStore.getInstance("PKCS12");
      store.load(null, null);
      store.setCertificateEntry("site", authority);
      return bytes(store, password);
    } catch (GeneralSecurityException | IOException unable) {
      throw unable(unable);
    }
  }

  private static byte[] bytes(KeyStore store, String password)
      throws GeneralSecurityException, IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    store.store(bytes, password.toCharArray());
    return bytes.toByteArray();
  }

  private static SecurityFilesException unable(Exception cause) {
    return new SecurityFilesException("This Java cannot write key stores.", cause);
  }
}
