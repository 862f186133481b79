package org.maestro.rats.security;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;

/**
 * The persons of a secured site as its files name them now: who is taken out, or gets another role
 * or password, is so with the next question. Any thread; to check a password takes about a tenth of
 * a second of a processor.
 */
public final class SitePersons {
  /** Of nobody: who has no name here takes as long to find out as who has no password. */
  private static final String NOBODY = PasswordHashes.slow(PasswordHashes.newPassword());

  private final Reread<Known> known;

  private record Known(SortedMap<String, Role> roles, Map<String, String> hashes) {}

  /**
   * @throws SecurityFilesException when the files cannot be used
   */
  SitePersons(Path usersFile, Path passwordsFile) {
    this.known =
        new Reread<>(
            "persons", List.of(usersFile, passwordsFile), () -> read(usersFile, passwordsFile));
  }

  /**
   * The password in a file of a person's own.
   *
   * @throws SecurityFilesException when it cannot be read, or others may read it
   */
  public static String passwordIn(Path file) {
    return PrivateFiles.secret(file).strip();
  }

  /** The role of who has that name; empty: there is no such person. */
  public Optional<Role> role(String name) {
    return Optional.ofNullable(known.now().roles().get(name));
  }

  /** Whether nobody can sign in. */
  public boolean isEmpty() {
    return known.now().roles().isEmpty();
  }

  /**
   * What stands for a person with the password that she has now: another one when that is another,
   * or when she was taken out and has come back. Not a secret to be told.
   */
  public Optional<String> identity(String name) {
    Known now = known.now();
    return Optional.ofNullable(now.hashes().get(name)).filter(of -> now.roles().containsKey(name));
  }

  /** Whether this is a person and the password hers. */
  public boolean isPassword(String name, String password) {
    Optional<String> hash = identity(name);
    return PasswordHashes.isOf(password, hash.orElse(NOBODY)) && hash.isPresent();
  }

  private static Known read(Path usersFile, Path passwordsFile) {
    SiteUsers users = SiteUsers.parse(PrivateFiles.text(usersFile), usersFile.toString());
    // A site that was made before there were persons has no such file.
    return new Known(
        users.persons(),
        users.persons().isEmpty() ? Map.of() : hashes(PrivateFiles.secret(passwordsFile)));
  }

  /** What is kept of passwords, by the person. */
  static Map<String, String> hashes(String passwords) {
    Map<String, String> hashes = new HashMap<>();
    for (String line : passwords.lines().toList()) {
      int colon = line.indexOf(':');
      if (colon > 0) {
        hashes.put(line.substring(0, colon), line.substring(colon + 1));
      }
    }
    return hashes;
  }
}
