package org.maestro.rats.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SitePersonsTest {
  @TempDir Path directory;

  @BeforeEach
  void anOperatorAndAViewer() {
    with(Map.of("alice", Role.OPERATOR, "screen", Role.VIEWER));
  }

  private void with(Map<String, Role> persons) {
    SecureSite.in(directory)
        .make(
            new SiteUsers(
                "home",
                List.of("127.0.0.1"),
                new TreeSet<>(List.of("maestro")),
                new TreeSet<>(List.of("lamp")),
                new TreeSet<>(),
                new TreeSet<>(List.of("alice")),
                new TreeMap<>(persons)));
  }

  private SitePersons persons() {
    return SiteSecurity.open(directory).persons();
  }

  private String password(String person) {
    return SiteSecurity.open(directory).console(person).orElseThrow().password().orElseThrow();
  }

  @Test
  void eachHasARoleAndAPasswordOfHerOwn() {
    SitePersons persons = persons();
    assertThat(persons.role("alice")).contains(Role.OPERATOR);
    assertThat(persons.role("screen")).contains(Role.VIEWER);
    assertThat(persons.role("lamp")).isEmpty();
    assertThat(persons.isPassword("alice", password("alice"))).isTrue();
    assertThat(persons.isPassword("alice", password("screen"))).isFalse();
    assertThat(persons.isPassword("alice", "")).isFalse();
    assertThat(persons.isPassword("nobody", password("alice"))).isFalse();
  }

  @Test
  void whoAdministersIsTheFirstWhosePasswordIsHere() throws IOException {
    assertThat(SiteSecurity.open(directory).administrator()).isEmpty();
    with(Map.of("bill", Role.ADMINISTRATOR, "carol", Role.ADMINISTRATOR));
    assertThat(SiteSecurity.open(directory).administrator().orElseThrow().user()).isEqualTo("bill");
    Files.delete(file("bill/console-password"));
    assertThat(SiteSecurity.open(directory).administrator().orElseThrow().user())
        .isEqualTo("carol");
  }

  @Test
  void neitherABusPasswordNorAHashLetsAnybodyIn() {
    SitePersons persons = persons();
    assertThat(persons.isPassword("lamp", PrivateFiles.secret(file("lamp/password")).strip()))
        .isFalse();
    String hash = PrivateFiles.secret(directory.resolve("console/passwords")).split("[:\n]")[1];
    assertThat(hash).startsWith("$7$");
    assertThat(persons.isPassword("alice", hash)).isFalse();
  }

  @Test
  void whatTheFilesSayIsSoWithTheNextQuestion() {
    SitePersons persons = persons();
    String former = password("alice");
    String identity = persons.identity("alice").orElseThrow();
    with(Map.of());
    assertThat(persons.identity("alice")).as("the same password").contains(identity);
    SecureSite.in(directory).renew(List.of("alice"));
    assertThat(persons.isPassword("alice", former)).isFalse();
    assertThat(persons.isPassword("alice", password("alice"))).isTrue();
    assertThat(persons.identity("alice")).isPresent().isNotEqualTo(Optional.of(identity));
    with(Map.of("alice", Role.VIEWER));
    assertThat(persons.role("alice")).contains(Role.VIEWER);
    assertThat(persons.role("screen")).contains(Role.VIEWER);
    SecureSite.in(directory).revoke(List.of("alice"));
    assertThat(persons.role("alice")).isEmpty();
    assertThat(persons.isPassword("alice", former)).isFalse();
  }

  @Test
  void onesOwnPasswordIsWrittenIntoTheFile() {
    PrivateFiles.write(file("alice/console-password"), "correct horse battery\n");
    with(Map.of());
    assertThat(persons().isPassword("alice", "correct horse battery")).isTrue();
    PrivateFiles.write(file("alice/console-password"), "short\n");
    assertThatThrownBy(() -> with(Map.of()))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining("5 characters")
        .hasMessageContaining(file("alice/console-password").toString());
    assertThat(persons().isPassword("alice", "correct horse battery")).isTrue();
  }

  @Test
  void filesThatCannotBeUsedLeaveThePersonsAsTheyAre() throws Exception {
    SitePersons persons = persons();
    Files.writeString(directory.resolve("users.txt"), "nonsense\n");
    assertThat(persons.role("alice")).contains(Role.OPERATOR);
  }

  /** It may have been the right to read it that was missing, and no file has changed since. */
  @Test
  void filesThatCanBeUsedAgainAreReadAgain() throws Exception {
    SitePersons persons = persons();
    Path passwords = directory.resolve("console/passwords");
    Files.setPosixFilePermissions(passwords, PosixFilePermissions.fromString("rw-r--r--"));
    Path users = directory.resolve("users.txt");
    Files.writeString(users, Files.readString(users).replace("operator alice\n", ""));
    assertThat(persons.role("alice")).contains(Role.OPERATOR);
    Files.setPosixFilePermissions(passwords, PosixFilePermissions.fromString("rw-------"));
    assertThat(persons.role("alice")).isEmpty();
  }

  @Test
  void whoIsTakenOutDoesNotWaitForThePasswordOfAnother() throws Exception {
    PrivateFiles.write(file("screen/console-password"), "short\n");
    String hers = persons().identity("screen").orElseThrow();
    SecureSite.in(directory).revoke(List.of("alice"));
    assertThat(persons().role("alice")).isEmpty();
    assertThat(persons().identity("screen")).contains(hers);
  }

  @Test
  void aSiteOfBeforeHasNoPersons() throws Exception {
    Files.delete(directory.resolve("console/passwords"));
    Files.writeString(directory.resolve("users.txt"), "site home\nhost 127.0.0.1\nmember lamp\n");
    assertThat(persons().isEmpty()).isTrue();
    assertThat(persons().isPassword("alice", "")).isFalse();
  }

  @ParameterizedTest
  @CsvSource({
    "operator lamp, cannot be both a person at the console and a member",
    "viewer alice, has another role above",
    "operators alice, 'guest, viewer, operator or administrator'",
  })
  void aLineThatCannotBeIsSaid(String line, String problem) throws Exception {
    Path users = directory.resolve("users.txt");
    Files.writeString(users, Files.readString(users) + line + "\n");
    assertThatThrownBy(() -> SiteSecurity.open(directory))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining(problem);
  }

  private Path file(String ofUser) {
    return directory.resolve("users").resolve(ofUser);
  }
}
