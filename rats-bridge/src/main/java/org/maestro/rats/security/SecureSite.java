package org.maestro.rats.security;

import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.cert.X509Certificate;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Makes a site's security files, adds users to them, gives them new certificates, and takes users
 * out again. What there is otherwise (authority, passwords, certificates, rules) stays as it is.
 * What runs by the files takes up what has changed.
 */
public final class SecureSite {
  private static final Pattern STORE_PASSWORD = Pattern.compile("keyStorePassword=([^;<]+)");

  /** Of a password that a person has chosen. */
  private static final int FEWEST_CHARACTERS = 12;

  private final Path directory;
  private final Path authorityKey;

  private SecureSite(Path directory, Path authorityKey) {
    this.directory = directory;
    this.authorityKey = authorityKey;
  }

  /** A site whose authority's key is kept with its other files. */
  public static SecureSite in(Path directory) {
    return in(directory, directory.resolve("ca"));
  }

  /**
   * @param authority where the key of the site's authority is kept, which signs certificates and is
   *     not needed to run
   */
  public static SecureSite in(Path directory, Path authority) {
    return new SecureSite(
        directory.toAbsolutePath().normalize(),
        authority.toAbsolutePath().normalize().resolve(SiteSecurity.KEY));
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

  /** Makes the files of a site, the key of its authority among them. */
  public static SiteUsers make(
      Path directory,
      String site,
      List<String> hosts,
      Collection<String> controllers,
      Collection<String> members,
      Collection<String> guests) {
    return in(directory)
        .make(
            new SiteUsers(
                site,
                hosts,
                new TreeSet<>(controllers),
                new TreeSet<>(members),
                new TreeSet<>(),
                new TreeSet<>(guests),
                new TreeMap<>()));
  }

  /**
   * Writes all files below the directory, each for its owner only.
   *
   * @param wanted who belongs to it, beside those who do already
   * @return everybody who belongs to the site now
   * @throws SecurityFilesException when a file cannot be written, or a name cannot be one
   */
  public SiteUsers make(SiteUsers wanted) {
    String site = wanted.site();
    SiteUsers users = wanted;
    Path file = directory.resolve(SiteSecurity.USERS);
    if (Files.exists(file)) {
      SiteUsers former = SiteUsers.parse(PrivateFiles.text(file), file.toString());
      if (!former.site().equals(site)) {
        throw new SecurityFilesException(
            "%s is of the site %s; choose another directory for the site %s"
                .formatted(directory, former.site(), site));
      }
      users = users.and(former);
    }
    PrivateFiles.directory(directory);
    CertificateAuthority authority = authority(users.site());
    revoke(Set.of(), authority);
    if (!Files.exists(directory.resolve(SiteSecurity.RULES))) {
      write(SiteSecurity.RULES, CallRules.USUAL);
    }
    write(users, authority);
    return users;
  }

  /** Whether somebody may sign in at the console, as far as the files say. */
  public boolean hasPersons() {
    Path file = directory.resolve(SiteSecurity.USERS);
    return Files.exists(file)
        && !SiteUsers.parse(PrivateFiles.text(file), file.toString()).persons().isEmpty();
  }

  /**
   * Gives users new keys and certificates, and the broker too; those they have had stay good until
   * they are out of date. A person gets a new password, and the one that she had is good no more.
   *
   * @throws SecurityFilesException when one is no user of the site, or a file cannot be written
   */
  public void renew(Collection<String> ids) {
    SiteUsers users = present(ids);
    CertificateAuthority authority = authority(users.site());
    for (String id : ids) {
      if (users.all().contains(id)) {
        certify(id, authority);
      }
      if (users.containers().contains(id)) {
        certifyContainer(id, authority);
      }
      if (users.persons().containsKey(id)) {
        PrivateFiles.write(personal(id), PasswordHashes.newPassword() + "\n");
      }
    }
    write(users, authority);
  }

  /**
   * Takes users out of the site, and their certificates back.
   *
   * @throws SecurityFilesException when one is no user of the site, or a file cannot be written
   */
  public void revoke(Collection<String> ids) {
    SiteUsers users = present(ids);
    CertificateAuthority authority = authority(users.site());
    Set<BigInteger> numbers = new TreeSet<>();
    for (String id : ids) {
      for (String name : List.of(SiteSecurity.CERTIFICATE, SiteSecurity.CONTAINER_CERTIFICATE)) {
        Path file = directory.resolve(SiteSecurity.ofUser(id) + name);
        if (Files.exists(file)) {
          numbers.add(Pem.certificate(file).getSerialNumber());
        }
      }
    }
    revoke(numbers, authority);
    write(
        SiteSecurity.RULES,
        CallRules.without(ids, PrivateFiles.text(directory.resolve(SiteSecurity.RULES))));
    SiteUsers left = users.without(ids);
    write(left, authority, personsAsBefore(left));
    ids.forEach(id -> PrivateFiles.delete(directory.resolve(SiteSecurity.ofUser(id))));
  }

  private SiteUsers present(Collection<String> ids) {
    Path file = directory.resolve(SiteSecurity.USERS);
    SiteUsers users = SiteUsers.parse(PrivateFiles.text(file), file.toString());
    for (String id : ids) {
      if (!users.has(id)) {
        throw new SecurityFilesException(
            "The secured site %s has no user %s; its users stand in %s."
                .formatted(users.site(), id, file));
      }
    }
    return users;
  }

  private void write(SiteUsers users, CertificateAuthority authority) {
    write(users, authority, persons(users));
  }

  /**
   * @param persons found out before anything is written, as there may be something wrong with them
   */
  private void write(SiteUsers users, CertificateAuthority authority, String persons) {
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
    write(SiteSecurity.PERSONS, persons);
    write(SiteSecurity.USERS, users.text());
  }

  /** What the console keeps of the passwords of persons: those in their files, made or chosen. */
  private String persons(SiteUsers users) {
    Map<String, String> former = formerHashes();
    StringBuilder lines = new StringBuilder();
    for (String id : users.persons().keySet()) {
      Path file = personal(id);
      if (!Files.exists(file)) {
        PrivateFiles.write(file, PasswordHashes.newPassword() + "\n");
      }
      String password = PrivateFiles.secret(file).strip();
      if (password.length() < FEWEST_CHARACTERS) {
        throw new SecurityFilesException(
            "The password in %s has %d characters; write one of at least %d there, or remove the file to have one made."
                .formatted(file, password.length(), FEWEST_CHARACTERS));
      }
      String before = former.getOrDefault(id, "");
      // Another one would be the same password to her, and end her sessions.
      lines.append(
          line(id, PasswordHashes.isOf(password, before) ? before : PasswordHashes.slow(password)));
    }
    return lines.toString();
  }

  /**
   * The same as it was, whatever stands in the files now: who is taken out does not wait for it.
   */
  private String personsAsBefore(SiteUsers users) {
    StringBuilder lines = new StringBuilder();
    formerHashes()
        .forEach(
            (id, hash) -> {
              if (users.persons().containsKey(id)) {
                lines.append(line(id, hash));
              }
            });
    return lines.toString();
  }

  private static String line(String id, String hash) {
    return id + ":" + hash + "\n";
  }

  private Map<String, String> formerHashes() {
    Path file = directory.resolve(SiteSecurity.PERSONS);
    return Files.exists(file)
        ? new TreeMap<>(SitePersons.hashes(PrivateFiles.text(file)))
        : Map.of();
  }

  private Path personal(String id) {
    return directory.resolve(SiteSecurity.ofUser(id) + SiteSecurity.PERSONAL);
  }

  private CertificateAuthority authority(String site) {
    Path certificate = directory.resolve(SiteSecurity.AUTHORITY);
    if (Files.exists(certificate)) {
      if (!Files.exists(authorityKey)) {
        throw new SecurityFilesException(
            "The key of the site's authority, %s, is not there; it signs certificates and is not needed to run: name the directory where it is kept with --ca DIR."
                .formatted(authorityKey));
      }
      return CertificateAuthority.read(certificate, authorityKey);
    }
    CertificateAuthority made = CertificateAuthority.make(site);
    PrivateFiles.write(authorityKey, Pem.of(made.key()));
    PrivateFiles.write(certificate, pem(made.certificate()));
    return made;
  }

  private void revoke(Set<BigInteger> numbers, CertificateAuthority authority) {
    Path file = directory.resolve(SiteSecurity.REVOKED);
    RevocationList former =
        Files.exists(file)
            ? RevocationList.read(file, authority.certificate())
            : RevocationList.none();
    try {
      write(SiteSecurity.REVOKED, Pem.of(authority.revoking(former.and(numbers))));
    } catch (GeneralSecurityException unable) {
      throw new SecurityFilesException("This Java cannot write lists of certificates.", unable);
    }
  }

  /** Returns the password. */
  private String user(String id, CertificateAuthority authority) {
    Path password = directory.resolve(SiteSecurity.ofUser(id) + SiteSecurity.PASSWORD);
    if (!Files.exists(password)) {
      certify(id, authority);
      PrivateFiles.write(password, PasswordHashes.newPassword() + "\n");
    }
    return PrivateFiles.secret(password).strip();
  }

  private void certify(String id, CertificateAuthority authority) {
    write(id, authority, authority.user(id), SiteSecurity.KEY, SiteSecurity.CERTIFICATE);
  }

  private void certifyContainer(String id, CertificateAuthority authority) {
    write(
        id,
        authority,
        authority.container(id),
        SiteSecurity.CONTAINER_KEY,
        SiteSecurity.CONTAINER_CERTIFICATE);
  }

  private void write(
      String id,
      CertificateAuthority authority,
      CertificateAuthority.Identity identity,
      String key,
      String certificate) {
    String own = SiteSecurity.ofUser(id);
    write(own + key, Pem.of(identity.key()));
    write(own + certificate, pem(identity.certificate()));
    write(own + "ca.pem", pem(authority.certificate()));
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
      certifyContainer(id, authority);
    }
    write(own + SiteSecurity.TOKEN, token);
  }

  /** Anew each time, as the hosts may be others; returns the password of the key stores. */
  private String broker(SiteUsers users, CertificateAuthority authority) {
    CertificateAuthority.Identity identity = authority.broker(users.hosts());
    write("broker/certificate.pem", pem(identity.certificate()));
    write("broker/key.pem", Pem.of(identity.key()));
    String password = storePassword();
    PrivateFiles.write(
        directory.resolve("broker/broker.p12"),
        BrokerStores.own(password, identity, authority.certificate()));
    PrivateFiles.write(
        directory.resolve("broker/trust.p12"),
        BrokerStores.trusted(password, authority.certificate()));
    return password;
  }

  /** A broker that runs knows the one that it has begun with. */
  private String storePassword() {
    Path file = directory.resolve("artemis/broker.xml");
    if (Files.exists(file)) {
      Matcher known = STORE_PASSWORD.matcher(PrivateFiles.secret(file));
      if (known.find()) {
        return known.group(1);
      }
    }
    return PasswordHashes.newPassword();
  }

  private void write(String name, String text) {
    PrivateFiles.write(directory.resolve(name), text);
  }

  private static String pem(X509Certificate certificate) {
    try {
      return Pem.of(certificate);
    } catch (GeneralSecurityException unable) {
      throw new SecurityFilesException("This Java cannot write certificates.", unable);
    }
  }
}
