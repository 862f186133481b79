package org.maestro.rats.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.rats.member.CallPolicy;

/** A site's security files, and what is said when something is wrong with them. */
class SiteSecurityTest {

  @TempDir Path directory;

  @Test
  void filesAreTheirOwnersOnly() throws IOException {
    SecuredSite.files(directory);
    try (Stream<Path> files = Files.walk(directory)) {
      assertThat(files.skip(1))
          .allSatisfy(
              file ->
                  assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
                      .isEqualTo(Files.isDirectory(file) ? "rwx------" : "rw-------"));
    }
  }

  @Test
  void madeAgainItAddsUsersAndKeepsWhatItsUsersHave() {
    SecuredSite.files(directory);
    Map<String, String> before = texts("users");
    String authority = PrivateFiles.text(directory.resolve("ca/ca.pem"));
    PrivateFiles.write(directory.resolve("rules.txt"), "allow cca door *\n");
    SiteUsers users =
        SecureSite.make(directory, "home", List.of("example.org"), List.of(), List.of("shutter"));
    assertThat(users.members()).containsExactly("cam-1.a", "door", "lamp", "shutter");
    assertThat(users.controllers()).containsExactly("cca");
    assertThat(texts("users")).containsAllEntriesOf(before).containsKey("shutter/password");
    assertThat(PrivateFiles.text(directory.resolve("ca/ca.pem"))).isEqualTo(authority);
    SiteSecurity opened = SiteSecurity.open(directory);
    assertThat(opened.rules().allows("cca", "door", "open")).isTrue();
    assertThat(opened.rules().allows("cca", "lamp", "open")).isFalse();
    assertThatThrownBy(
            () -> SecureSite.make(directory, "other", List.of("h"), List.of(), List.of()))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining("is of the site home");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "users.txt",
        "rules.txt",
        "ca/ca.pem",
        "users/lamp/password",
        "users/lamp/certificate.pem",
        "users/lamp/key.pem",
        "users/cca/join-token",
        "users/cca/container.pem",
        "users/cca/container-key.pem",
        "artemis/broker.xml",
        "artemis/login.config",
        "artemis/users.properties",
        "artemis/roles.properties",
        "broker/broker.p12",
        "broker/trust.p12"
      })
  void tellsInOneSentenceWhichFileIsMissing(String name) throws IOException {
    SecuredSite.files(directory);
    Files.delete(directory.resolve(name));
    assertThatThrownBy(this::useAll)
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining(directory.resolve(name).toString())
        .hasMessageContaining("maestro secure");
  }

  @ParameterizedTest
  @ValueSource(strings = {"users/lamp/password", "users/lamp/key.pem", "artemis/broker.xml"})
  void refusesSecretsThatOthersCanRead(String name) throws IOException {
    SecuredSite.files(directory);
    Files.setPosixFilePermissions(
        directory.resolve(name), PosixFilePermissions.fromString("rw-r--r--"));
    assertThatThrownBy(this::useAll)
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining(directory.resolve(name).toString())
        .hasMessageContaining("chmod 600");
  }

  @ParameterizedTest
  @ValueSource(strings = {"users/lamp/certificate.pem", "users/lamp/key.pem", "ca/ca.pem"})
  void refusesWhatHoldsSomethingElse(String name) {
    SecuredSite.files(directory);
    PrivateFiles.write(directory.resolve(name), "garbage");
    assertThatThrownBy(this::useAll)
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining(directory.resolve(name).toString());
  }

  /** It would only keep everybody from connecting, for a reason that nobody is told. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "ca/ca.pem",
        "users/lamp/certificate.pem",
        "users/cca/container.pem",
        "broker/certificate.pem"
      })
  void refusesCertificatesThatAreOutOfDate(String name) throws IOException {
    SecuredSite.files(directory);
    try (InputStream expired =
        getClass().getResourceAsStream("/org/maestro/rats/security/expired.pem")) {
      PrivateFiles.write(directory.resolve(name), expired.readAllBytes());
    }
    assertThatThrownBy(this::useAll)
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining(directory.resolve(name).toString())
        .hasMessageContaining("2024")
        .hasMessageContaining("maestro secure");
  }

  @Test
  void knowsNoStrangers() {
    SecuredSite.files(directory);
    assertThatThrownBy(() -> SiteSecurity.open(directory).password("rose"))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining("--member rose");
    assertThatThrownBy(() -> SiteSecurity.open(directory.resolve("elsewhere")))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining("There is no directory");
    assertThatThrownBy(
            () -> SecureSite.make(directory, "home", List.of("h"), List.of(), List.of("a/b")))
        .isInstanceOf(SecurityFilesException.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"permit cca door *", "allow cca door", "allow rose door *"})
  void tellsTheLineOfARuleThatIsNone(String rule) {
    SecuredSite.files(directory);
    PrivateFiles.write(directory.resolve("rules.txt"), "# first\n" + rule + "\n");
    assertThatThrownBy(() -> SiteSecurity.open(directory))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining("rules.txt, line 2");
  }

  @Test
  void theUsualRulesLetControllersCallAndMembersAnswerThem() {
    SecuredSite.files(directory);
    CallPolicy rules = SiteSecurity.open(directory).rules();
    assertThat(rules.allows("cca", "door", "open")).isTrue();
    assertThat(rules.allows("lamp", "door", "open")).isFalse();
    assertThat(rules.allows("lamp", "door", "$ping")).isTrue();
    assertThat(rules.allows("lamp", "cca", "$offer")).isTrue();
    assertThat(rules.allows("lamp", "door", "$cancel")).isFalse();
    assertThat(rules.allows("stranger", "door", "$ping")).isFalse();
  }

  @Test
  void rulesAreThoseOfTheFileEachTimeAlsoWhenItChangesTwiceInAMoment() {
    SecuredSite.files(directory);
    CallPolicy rules = SiteSecurity.open(directory).rules();
    assertThat(rules.allows("lamp", "door", "wave")).isFalse();
    for (int round = 0; round < 20; round++) {
      rules("allow lamp door wave");
      assertThat(rules.allows("lamp", "door", "wave")).isTrue();
      rules("allow lamp door grip");
      assertThat(rules.allows("lamp", "door", "wave")).isFalse();
    }
  }

  @Test
  void aWrongFileLeavesTheRulesAndSaysSoOnceWithItsLine() throws IOException {
    SecuredSite.files(directory);
    CallPolicy rules = SiteSecurity.open(directory).rules();
    try (LogLines log = LogLines.of(SiteRules.class)) {
      rules("allow lamp door wave\nallow lamp dor *");
      for (int question = 0; question < 3; question++) {
        assertThat(rules.allows("cca", "door", "wave")).isTrue();
        assertThat(rules.allows("lamp", "door", "wave")).isFalse();
      }
      Files.delete(directory.resolve("rules.txt"));
      assertThat(rules.allows("cca", "door", "wave")).isTrue();
      assertThat(log.lines()).hasSize(2);
      assertThat(log.lines().get(0)).contains("rules.txt, line 2", "\"dor\"", "stay");
      assertThat(log.lines().get(1)).contains("rules.txt is missing");
    }
    rules("allow lamp door wave");
    assertThat(rules.allows("lamp", "door", "wave")).isTrue();
    assertThat(rules.allows("cca", "door", "wave")).isFalse();
  }

  private void rules(String text) {
    PrivateFiles.write(directory.resolve("rules.txt"), text + "\n");
  }

  @Test
  void brokersKeepNoPasswordAndCredentialsDoNotShowTheirs() {
    SecuredSite.files(directory);
    SiteSecurity security = SiteSecurity.open(directory);
    String secret = security.password("lamp").password().orElseThrow();
    assertThat(security.password("lamp").toString()).doesNotContain(secret);
    assertThat(texts("artemis").values()).noneMatch(text -> text.contains(secret));
    assertThat(texts("mosquitto").values()).noneMatch(text -> text.contains(secret));
  }

  private void useAll() {
    SiteSecurity security = SiteSecurity.open(directory);
    security.password("lamp");
    security.certificate("lamp");
    security.container("cca");
    security.artemis();
  }

  private Map<String, String> texts(String below) {
    Map<String, String> texts = new TreeMap<>();
    Path root = directory.resolve(below);
    try (Stream<Path> files = Files.walk(root)) {
      files
          .filter(Files::isRegularFile)
          .forEach(file -> texts.put(root.relativize(file).toString(), PrivateFiles.text(file)));
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
    return texts;
  }
}
