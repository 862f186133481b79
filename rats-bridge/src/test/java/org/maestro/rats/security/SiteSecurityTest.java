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
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
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
        "ca/revoked.pem",
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

  /** Each by itself, whoever needs it: also one that this process would not read. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "join-token",
        "ca/key.pem",
        "broker/key.pem",
        "broker/broker.p12",
        "broker/trust.p12",
        "artemis/broker.xml",
        "artemis/users.properties",
        "mosquitto/passwords",
        "users/lamp/password",
        "users/lamp/key.pem",
        "users/door/password",
        "users/door/key.pem",
        "users/cca/password",
        "users/cca/key.pem",
        "users/cca/join-token",
        "users/cca/container-key.pem"
      })
  void refusesASecretThatOthersCanRead(String name) throws IOException {
    SecuredSite.files(directory);
    Files.setPosixFilePermissions(
        directory.resolve(name), PosixFilePermissions.fromString("rw-r--r--"));
    assertThatThrownBy(() -> SiteSecurity.open(directory))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining(directory.resolve(name).toString())
        .hasMessageContaining("chmod 600");
  }

  /** So that the list above is whole: all others hold what anybody may know. */
  @Test
  void noOtherFileHoldsASecret() throws IOException {
    SecuredSite.files(directory);
    try (Stream<Path> files = Files.walk(directory)) {
      assertThat(
              files
                  .filter(Files::isRegularFile)
                  .map(file -> file.getFileName().toString())
                  .filter(name -> !PrivateFiles.SECRETS.contains(name)))
          .containsOnly(
              "users.txt",
              "rules.txt",
              "ca.pem",
              "revoked.pem",
              "certificate.pem",
              "container.pem",
              "login.config",
              "roles.properties",
              "certificates.properties",
              "mosquitto.conf",
              "acl");
    }
  }

  @Test
  void runsWithoutTheKeyOfItsAuthorityAndSaysWhoNeedsIt() throws IOException {
    Path safe = directory.resolve("safe");
    Path files = directory.resolve("files");
    SecuredSite.files(files);
    Files.createDirectory(safe);
    Files.move(files.resolve("ca/key.pem"), safe.resolve("key.pem"));
    SiteSecurity site = SiteSecurity.open(files);
    site.artemis();
    site.container("cca");
    assertThatThrownBy(() -> SecureSite.in(files).revoke(List.of("lamp")))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining("not needed to run")
        .hasMessageContaining("--ca DIR");
    assertThat(site.users().members()).contains("lamp");
    SecureSite.in(files, safe).revoke(List.of("lamp"));
    assertThat(SiteSecurity.open(files).users().members()).doesNotContain("lamp");
    assertThat(files.resolve("users/lamp")).doesNotExist();
    assertThat(files.resolve("ca/key.pem")).doesNotExist();
  }

  @Test
  void itsAuthoritysKeyCanLiveElsewhereFromTheBeginning() {
    Path safe = directory.resolve("safe");
    Path files = directory.resolve("files");
    SecureSite.in(files, safe)
        .make(
            new SiteUsers(
                "home",
                List.of("h"),
                new TreeSet<>(Set.of("cca")),
                new TreeSet<>(),
                new TreeSet<>(),
                new TreeSet<>(),
                new TreeMap<>()));
    assertThat(safe.resolve("key.pem")).exists();
    assertThat(files.resolve("ca/key.pem")).doesNotExist();
    assertThat(SiteSecurity.open(files).container("cca").user()).isEqualTo("cca");
  }

  @Test
  void newCertificatesAreOnesOwnAndFormerOnesStayGood() {
    SecuredSite.files(directory);
    ContainerAccess before = SiteSecurity.open(directory).container("cca");
    SecureSite.in(directory).renew(List.of("cca", "lamp"));
    ContainerAccess after = SiteSecurity.open(directory).container("cca");
    assertThat(after.certificate()).isNotEqualTo(before.certificate());
    assertThat(after.holder(before.certificate())).contains("cca");
    assertThat(after.holder(after.certificate())).contains("cca");
    assertThatThrownBy(() -> SecureSite.in(directory).renew(List.of("nobody")))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining("no user nobody");
  }

  @Test
  void aCertificateThatWasTakenBackIsNobodysThoughAnotherHasTheNameNow() {
    SecuredSite.files(directory);
    ContainerAccess before = SiteSecurity.open(directory).container("cca");
    SecureSite.in(directory).revoke(List.of("cca"));
    SecureSite.make(directory, "home", List.of("127.0.0.1"), List.of("cca"), List.of());
    ContainerAccess after = SiteSecurity.open(directory).container("cca");
    assertThat(after.holder(before.certificate())).isEmpty();
    assertThat(after.holder(after.certificate())).contains("cca");
  }

  /** Between the writing of the one and of the other a process that reads them waits. */
  @Test
  void aKeyAndACertificateOfDifferentAgeAreNotUsed() throws IOException {
    SecuredSite.files(directory);
    byte[] former = Files.readAllBytes(directory.resolve("users/cca/container.pem"));
    SecureSite.in(directory).renew(List.of("cca"));
    PrivateFiles.write(directory.resolve("users/cca/container.pem"), former);
    assertThatThrownBy(() -> SiteSecurity.open(directory).container("cca"))
        .isInstanceOf(SecurityFilesException.class)
        .hasMessageContaining("do not belong together");
  }

  @Test
  void rulesAboutWhoWasTakenOutAreRulesNoMore() {
    SecuredSite.files(directory);
    rules("allow lamp door wave\nallow door lamp *\nallow cca door *");
    SecureSite.in(directory).revoke(List.of("lamp"));
    assertThat(PrivateFiles.text(directory.resolve("rules.txt")))
        .isEqualTo(
            "# revoked: allow lamp door wave\n# revoked: allow door lamp *\nallow cca door *\n");
    assertThat(SiteSecurity.open(directory).rules().allows("cca", "door", "x")).isTrue();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"users/lamp/certificate.pem", "users/lamp/key.pem", "ca/ca.pem", "ca/revoked.pem"})
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
    try (LogLines log = LogLines.of(Reread.class)) {
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
