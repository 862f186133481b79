package org.maestro.rats.security;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.PrivateKey;
import java.security.cert.Certificate;
import java.security.cert.X509Certificate;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.net.ssl.KeyManager;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.transport.Credentials;

/** A secured site's files as members, controllers and the embedded broker read them. */
public final class SiteSecurity {

  static final String USERS = "users.txt";
  static final String RULES = "rules.txt";
  static final String AUTHORITY = "ca/ca.pem";
  static final String REVOKED = "ca/revoked.pem";
  static final String PASSWORD = "password";
  static final String CERTIFICATE = "certificate.pem";
  static final String KEY = "key.pem";

  /** What the console keeps of the passwords of persons. */
  static final String PERSONS = "console/passwords";

  /** A person's own password for the console. */
  static final String PERSONAL = "console-password";

  static final String TOKEN = "join-token";
  static final String CONTAINER_CERTIFICATE = "container.pem";
  static final String CONTAINER_KEY = "container-key.pem";

  private static final char[] IN_MEMORY = new char[0];

  private final Path directory;
  private final SiteUsers users;
  private final CallPolicy rules;
  private final X509Certificate authority;

  private SiteSecurity(
      Path directory, SiteUsers users, CallPolicy rules, X509Certificate authority) {
    this.directory = directory;
    this.users = users;
    this.rules = rules;
    this.authority = authority;
  }

  /**
   * Reads what everybody needs.
   *
   * @throws SecurityFilesException when something is missing, unreadable, open to others or broken
   */
  public static SiteSecurity open(Path directory) {
    Path absolute = directory.toAbsolutePath().normalize();
    if (!Files.isDirectory(absolute)) {
      throw new SecurityFilesException(
          "There is no directory " + directory + "; ./maestro secure " + directory + " makes it.");
    }
    PrivateFiles.requireSecretsPrivate(absolute);
    Path usersFile = absolute.resolve(USERS);
    SiteUsers users = SiteUsers.parse(PrivateFiles.text(usersFile), usersFile.toString());
    Path rulesFile = absolute.resolve(RULES);
    CallPolicy rules =
        new SiteRules(
            List.of(rulesFile, usersFile),
            () ->
                CallRules.parse(
                    PrivateFiles.text(rulesFile),
                    rulesFile.toString(),
                    SiteUsers.parse(PrivateFiles.text(usersFile), usersFile.toString())));
    return new SiteSecurity(absolute, users, rules, Pem.certificate(absolute.resolve(AUTHORITY)));
  }

  /** Whether the site has the user now; users are added and taken out while all runs. */
  public boolean hasNow(String id) {
    Path usersFile = directory.resolve(USERS);
    return SiteUsers.parse(PrivateFiles.text(usersFile), usersFile.toString()).all().contains(id);
  }

  public SiteUsers users() {
    return users;
  }

  /** Who may call what of whom, as the files say it each time that it is asked. */
  public CallPolicy rules() {
    return rules;
  }

  /**
   * Where the embedded broker's files are.
   *
   * @throws SecurityFilesException when one is missing, unreadable, open to others or out of date
   */
  public Path artemis() {
    Pem.certificate(directory.resolve("broker/certificate.pem"));
    for (String name :
        new String[] {
          "artemis/broker.xml",
          "artemis/login.config",
          "artemis/users.properties",
          "artemis/roles.properties",
          "artemis/certificates.properties",
          "broker/broker.p12",
          "broker/trust.p12"
        }) {
      PrivateFiles.bytes(directory.resolve(name));
      PrivateFiles.requirePrivate(directory.resolve(name));
    }
    return directory.resolve("artemis");
  }

  /**
   * To connect as a user by password.
   *
   * @throws SecurityFilesException when the site has no such user, or its files cannot be used
   */
  public Credentials password(String id) {
    requireUser(id);
    String secret = PrivateFiles.secret(file(id, PASSWORD)).strip();
    if (secret.isEmpty()) {
      throw new SecurityFilesException("The security file " + file(id, PASSWORD) + " is empty.");
    }
    return new Credentials(id, Optional.of(secret), context(Optional.empty()));
  }

  /**
   * To connect as a user by its certificate.
   *
   * @throws SecurityFilesException when the site has no such user, or its files cannot be used
   */
  public Credentials certificate(String id) {
    requireUser(id);
    PrivateKey key = Pem.key(file(id, KEY));
    X509Certificate certificate = Pem.certificate(file(id, CERTIFICATE));
    return new Credentials(
        id,
        Optional.empty(),
        context(Optional.of(new CertificateAuthority.Identity(certificate, key))));
  }

  /**
   * To be a container of the site's platform, in the process of a controller or a guest.
   *
   * @throws SecurityFilesException when the site has no such user, or its files cannot be used
   */
  public ContainerAccess container(String id) {
    if (!users.containers().contains(id)) {
      throw new SecurityFilesException(
          "The secured site %s has no user %s who may join its platform; ./maestro secure %s --guest %s adds it."
              .formatted(users.site(), id, directory, id));
    }
    String token = PrivateFiles.secret(file(id, TOKEN)).strip();
    if (token.isEmpty()) {
      throw new SecurityFilesException("The security file " + file(id, TOKEN) + " is empty.");
    }
    CertificateAuthority.Identity identity =
        new CertificateAuthority.Identity(
            Pem.certificate(file(id, CONTAINER_CERTIFICATE)), Pem.key(file(id, CONTAINER_KEY)));
    return new ContainerAccess(
        id,
        users.containers(),
        users.guests(),
        authority,
        RevocationList.read(directory.resolve(REVOKED), authority),
        identity,
        context(Optional.of(identity)),
        token);
  }

  /**
   * The persons who may sign in at the console.
   *
   * @throws SecurityFilesException when the files cannot be used
   */
  public SitePersons persons() {
    return new SitePersons(directory.resolve(USERS), directory.resolve(PERSONS));
  }

  /**
   * To serve by TLS as the site's own machine, by the certificate of its broker.
   *
   * @throws SecurityFilesException when the files cannot be used
   */
  public SSLContext server() {
    return context(
        Optional.of(
            new CertificateAuthority.Identity(
                Pem.certificate(directory.resolve("broker/certificate.pem")),
                Pem.key(directory.resolve("broker/key.pem")))));
  }

  /**
   * To sign in at the console as a person by her password.
   *
   * @return empty when the site has no such person
   * @throws SecurityFilesException when the files cannot be used
   */
  public Optional<Credentials> console(String id) {
    return users.persons().containsKey(id)
        ? Optional.of(
            new Credentials(
                id,
                Optional.of(PrivateFiles.secret(file(id, PERSONAL)).strip()),
                context(Optional.empty())))
        : Optional.empty();
  }

  /**
   * To sign in at the console as an administrator: of several the first by name whose password is
   * kept here.
   *
   * @return empty when there is none
   * @throws SecurityFilesException when the files cannot be used
   */
  public Optional<Credentials> administrator() {
    return users.persons().entrySet().stream()
        .filter(person -> person.getValue() == Role.ADMINISTRATOR)
        .map(Map.Entry::getKey)
        .filter(id -> Files.isReadable(file(id, PERSONAL)))
        .sorted()
        .findFirst()
        .flatMap(this::console);
  }

  /** What {@link #container} reads, to see when that has to be read again. */
  public WatchedFiles containerFiles(String id) {
    return new WatchedFiles(
        List.of(
            directory.resolve(USERS),
            directory.resolve(REVOKED),
            file(id, CONTAINER_KEY),
            file(id, CONTAINER_CERTIFICATE),
            file(id, TOKEN)));
  }

  /** Where the files are. */
  public Path directory() {
    return directory;
  }

  static String ofUser(String id) {
    return "users/" + id + "/";
  }

  private Path file(String id, String name) {
    return directory.resolve(ofUser(id) + name);
  }

  private void requireUser(String id) {
    if (!users.all().contains(id)) {
      throw new SecurityFilesException(
          "The secured site %s has no user %s; ./maestro secure %s --member %s adds it."
              .formatted(users.site(), id, directory, id));
    }
  }

  private SSLContext context(Optional<CertificateAuthority.Identity> identity) {
    try {
      KeyStore trusted = emptyStore();
      trusted.setCertificateEntry("site", authority);
      TrustManagerFactory trust =
          TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
      trust.init(trusted);
      SSLContext context = SSLContext.getInstance("TLS");
      context.init(keys(identity), trust.getTrustManagers(), null);
      return context;
    } catch (GeneralSecurityException | IOException unable) {
      throw new SecurityFilesException(
          "The certificates below " + directory + " cannot be used: " + unable.getMessage(),
          unable);
    }
  }

  private KeyManager[] keys(Optional<CertificateAuthority.Identity> identity)
      throws GeneralSecurityException, IOException {
    if (identity.isEmpty()) {
      return new KeyManager[0];
    }
    KeyStore own = emptyStore();
    own.setKeyEntry(
        "own",
        identity.get().key(),
        IN_MEMORY,
        new Certificate[] {identity.get().certificate(), authority});
    KeyManagerFactory keys = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
    keys.init(own, IN_MEMORY);
    return keys.getKeyManagers();
  }

  private static KeyStore emptyStore() throws GeneralSecurityException, IOException {
    KeyStore store = KeyStore.getInstance("PKCS12");
    store.load(null, null);
    return store;
  }
}
