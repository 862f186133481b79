package org.maestro.rats.security;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.ConcurrentHashMap;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The persons of a secured site as its files name them now: who is taken out, or gets another role,
 * is so with the next question. Files that cannot be used leave them as they are, which is said
 * once. Any thread; a password takes about a tenth of a second of a processor.
 */
public final class SitePersons {
  private static final Logger LOG = LoggerFactory.getLogger(SitePersons.class);

  /** Of nobody: who has no name here takes as long to find out as who has no password. */
  private static final String NOBODY = PasswordHashes.slow(PasswordHashes.newPassword());

  private static final String DIGEST = "HmacSHA256";

  private final Path usersFile;
  private final Path passwordsFile;
  private final WatchedFiles files;
  private final SecretKeySpec key =
      new SecretKeySpec(PasswordHashes.newPassword().getBytes(StandardCharsets.UTF_8), DIGEST);
  private final Map<String, Proven> proven = new ConcurrentHashMap<>();
  private Known known;

  /** What was found to be a person's password is not kept as it is. */
  private record Proven(String hash, byte[] digest) {}

  private record Known(SortedMap<String, Role> roles, Map<String, String> hashes) {}

  /**
   * @throws SecurityFilesException when the files cannot be used
   */
  SitePersons(Path usersFile, Path passwordsFile) {
    this.usersFile = usersFile;
    this.passwordsFile = passwordsFile;
    this.files = new WatchedFiles(List.of(usersFile, passwordsFile));
    this.known = read();
  }

  /** The role of who has that name; empty: there is no such person. */
  public Optional<Role> role(String name) {
    return Optional.ofNullable(present().roles().get(name));
  }

  /** Whether nobody can sign in. */
  public boolean isEmpty() {
    return present().roles().isEmpty();
  }

  /** Whether this is a person and the password hers. */
  public boolean isPassword(String name, String password) {
    Optional<String> hash = hash(name);
    boolean isHers = PasswordHashes.isOf(password, hash.orElse(NOBODY)) && hash.isPresent();
    if (isHers) {
      proven.put(name, new Proven(hash.get(), digest(password)));
    }
    return isHers;
  }

  /** Whether it was found to be hers before, and still is; found out at once. */
  public boolean isProven(String name, String password) {
    Proven before = proven.get(name);
    return before != null
        && hash(name).filter(before.hash()::equals).isPresent()
        && MessageDigest.isEqual(before.digest(), digest(password));
  }

  private Optional<String> hash(String name) {
    Known now = present();
    return Optional.ofNullable(now.hashes().get(name)).filter(of -> now.roles().containsKey(name));
  }

  private byte[] digest(String password) {
    try {
      Mac mac = Mac.getInstance(DIGEST);
      mac.init(key);
      return mac.doFinal(password.getBytes(StandardCharsets.UTF_8));
    } catch (GeneralSecurityException unable) {
      throw new SecurityFilesException("This Java does not know " + DIGEST + ".", unable);
    }
  }

  private synchronized Known present() {
    if (files.haveChanged()) {
      try {
        known = read();
        LOG.info("The persons of {} were read again", usersFile);
      } catch (SecurityFilesException unusable) {
        LOG.error("The persons stay as they were: {}", unusable.getMessage());
      }
    }
    return known;
  }

  private Known read() {
    SiteUsers users = SiteUsers.parse(PrivateFiles.text(usersFile), usersFile.toString());
    Map<String, String> hashes = new HashMap<>();
    // A site that was made before there were persons has no such file.
    if (!users.persons().isEmpty()) {
      for (String line : PrivateFiles.secret(passwordsFile).lines().toList()) {
        int colon = line.indexOf(':');
        if (colon > 0) {
          hashes.put(line.substring(0, colon), line.substring(colon + 1));
        }
      }
    }
    return new Known(users.persons(), hashes);
  }
}
