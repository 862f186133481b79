package org.maestro.platform.guard;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLServerSocket;
import javax.net.ssl.SSLSocket;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.fixtures.WireTap;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteSecurity;

/** Who is let in at the port where containers join: certificate and token, and nobody else. */
class GateTest {
  private static final String LOOPBACK = "127.0.0.1";
  private static final int BACKLOG = 50;
  private static final String PREFERENCE = "(prefers dave-evenings Opera)";
  private static final Duration SOON = Duration.ofSeconds(30);

  @TempDir static Path directory;
  private static Path site;
  private static ServerSocket gate;

  @BeforeAll
  static void open() throws IOException {
    site = files("site", "home");
    Guard main = guard(site, "maestro");
    gate = new Gate(new ServerSocket(0, BACKLOG, InetAddress.getByName(LOOPBACK)), main);
  }

  @AfterAll
  static void close() throws IOException {
    gate.close();
  }

  /** Who only asks whether it would be let in is not handed on: JADE would wait for its words. */
  @Test
  void whoHasCertificateAndTokenIsLetInAndHeard() throws Exception {
    assertThat(guard(site, "console").objection(LOOPBACK, gate.getLocalPort())).isEmpty();
    try (Socket robots = guard(site, "container-robots").call(LOOPBACK, gate.getLocalPort());
        Socket there = gate.accept()) {
      robots.getOutputStream().write(7);
      robots.getOutputStream().flush();
      assertThat(there.getInputStream().read()).isEqualTo(7);
    }
  }

  /** What agents tell each other of persons, and what lets a container in (ADE, 2 and 5; A31). */
  @Test
  void whoTapsTheWireBetweenContainersReadsNothing() throws Exception {
    String token = Files.readString(site.resolve("users/container-robots/join-token")).strip();
    try (WireTap tap = new WireTap(gate.getLocalPort());
        Socket robots = guard(site, "container-robots").call(LOOPBACK, tap.port());
        Socket there = gate.accept()) {
      assertThat(said(robots, there)).isEqualTo(PREFERENCE);
      assertThat(said(there, robots)).isEqualTo(PREFERENCE);
      assertThat(tap.bytes()).isGreaterThan(2 * PREFERENCE.length() + token.length());
      assertThat(tap.hasHeard(PREFERENCE)).isFalse();
      assertThat(token).isNotBlank();
      assertThat(tap.hasHeard(token)).isFalse();
    }
    try (ServerSocket open = new ServerSocket(0, BACKLOG, InetAddress.getByName(LOOPBACK));
        WireTap tap = new WireTap(open.getLocalPort());
        Socket robots = new Socket(LOOPBACK, tap.port());
        Socket there = open.accept()) {
      assertThat(said(robots, there)).isEqualTo(PREFERENCE);
      assertThat(tap.hasHeard(PREFERENCE)).as("where nothing is sealed it is read").isTrue();
    }
  }

  private static String said(Socket from, Socket to) throws IOException {
    from.getOutputStream().write(PREFERENCE.getBytes(UTF_8));
    from.getOutputStream().flush();
    return new String(to.getInputStream().readNBytes(PREFERENCE.length()), UTF_8);
  }

  @Test
  void aWrongTokenIsRefusedWithTheReason() {
    Path copy = copy("wrong-token");
    write(copy.resolve("users/container-robots/join-token"), "guessed\n");
    assertThat(objection(guard(copy, "container-robots")))
        .contains("container-robots does not show the site's join token");
  }

  @Test
  void theCertificateOfAnotherSiteIsRefused() {
    assertThat(objection(guard(files("elsewhere", "home"), "container-robots")))
        .contains("Nobody of the secured site home answers");
  }

  /** It has a certificate of the site, and may have seen the token somewhere. */
  @Test
  void aLampOfTheSiteIsNoContainer() throws IOException {
    Path copy = copy("lamp");
    Path robots = copy.resolve("users/container-robots");
    Path lamp = copy.resolve("users/lamp");
    Files.copy(lamp.resolve("certificate.pem"), replaced(robots.resolve("container.pem")));
    Files.copy(lamp.resolve("key.pem"), replaced(robots.resolve("container-key.pem")));
    assertThat(objection(guard(copy, "container-robots")))
        .contains("its certificate is that of nobody who may be a container of the site home");
  }

  /** Whom a container calls has to be one, too: else it would be told the token. */
  @Test
  void aLampThatAnswersInTheMainContainersPlaceIsToldNoToken() throws Exception {
    SSLContext lamp = SiteSecurity.open(site).certificate("lamp").tls();
    try (SSLServerSocket impostor =
        (SSLServerSocket)
            lamp.getServerSocketFactory()
                .createServerSocket(0, 1, InetAddress.getByName(LOOPBACK))) {
      CompletableFuture<Integer> heard = new CompletableFuture<>();
      Thread listener =
          new Thread(
              () -> {
                try (SSLSocket socket = (SSLSocket) impostor.accept()) {
                  heard.complete(socket.getInputStream().read());
                } catch (IOException refused) {
                  heard.complete(-1);
                }
              });
      listener.setDaemon(true);
      listener.start();
      assertThat(guard(site, "container-robots").objection(LOOPBACK, impostor.getLocalPort()))
          .isPresent();
      assertThat(heard.get(10, TimeUnit.SECONDS)).isEqualTo(-1);
    }
  }

  @Test
  void whoSpeaksNoTlsOrNothingHoldsNobodyUp() throws Exception {
    try (Socket silent = new Socket(LOOPBACK, gate.getLocalPort());
        Socket plain = new Socket(LOOPBACK, gate.getLocalPort())) {
      plain.getOutputStream().write(new byte[64]);
      plain.getOutputStream().flush();
      plain.setSoTimeout(5_000);
      assertThat(plain.getInputStream().readAllBytes()).hasSizeLessThan(64);
      try (Socket robots = guard(site, "container-robots").call(LOOPBACK, gate.getLocalPort());
          Socket there = gate.accept()) {
        assertThat(there.getPort()).isEqualTo(robots.getLocalPort());
      }
      assertThat(silent.isClosed()).isFalse();
    }
  }

  @Test
  void whoWaitsAtAGateThatClosesWaitsNoMore() throws Exception {
    Guard main = guard(site, "maestro");
    Gate another = new Gate(new ServerSocket(0, BACKLOG, InetAddress.getByName(LOOPBACK)), main);
    CompletableFuture<Exception> ended = new CompletableFuture<>();
    Thread waiting =
        new Thread(
            () -> {
              try {
                another.accept();
              } catch (IOException closed) {
                ended.complete(closed);
              }
            });
    waiting.start();
    another.close();
    assertThat(ended.get(10, TimeUnit.SECONDS)).isInstanceOf(SocketException.class);
  }

  /** Nothing is started again: neither the platform's process nor that of the others. */
  @Test
  void whoIsTakenOutOfTheSiteIsCutOffAndLetInNoMore() throws Exception {
    Path files = files("shrinking", "home");
    try (ServerSocket own = gate(files);
        SSLSocket robots = call(files, "container-robots", own);
        Socket there = own.accept();
        SSLSocket console = call(files, "console", own);
        Socket its = own.accept()) {
      Guard former = guard(files, "container-robots");
      SecureSite.in(files).revoke(List.of("container-robots"));
      robots.setSoTimeout((int) SOON.toMillis());
      assertThat(robots.getInputStream().read()).isNegative();
      await().atMost(SOON).until(there::isClosed);
      assertThat(former.objection(LOOPBACK, own.getLocalPort()).orElse(""))
          .contains("its certificate is that of nobody who may be a container");
      assertThat(its.isClosed()).isFalse();
      console.getOutputStream().write(1);
      assertThat(its.getInputStream().read()).isEqualTo(1);
    }
  }

  @Test
  void whatWasTakenBackIsNoGoodThoughSomebodyHasTheNameAgain() throws Exception {
    Path files = files("changing", "home");
    try (ServerSocket own = gate(files)) {
      X509Certificate former = SiteSecurity.open(files).container("console").certificate();
      SecureSite.in(files).revoke(List.of("console"));
      files("changing", "home");
      await()
          .atMost(SOON)
          .until(() -> guard(files, "console").objection(LOOPBACK, own.getLocalPort()).isEmpty());
      assertThat(SiteSecurity.open(files).container("console").holder(former)).isEmpty();
    }
  }

  @Test
  void aNewCertificateIsShownAndBelievedAtOnce() throws Exception {
    Path files = files("renewed", "home");
    try (ServerSocket own = gate(files);
        SSLSocket before = call(files, "console", own);
        Socket there = own.accept()) {
      X509Certificate first = shown(before);
      SecureSite.in(files).renew(List.of("maestro", "console"));
      await()
          .atMost(SOON)
          .untilAsserted(
              () -> {
                try (SSLSocket now = call(files, "console", own);
                    Socket its = own.accept()) {
                  assertThat(shown(now)).isNotEqualTo(first);
                  assertThat(its.isClosed()).isFalse();
                }
              });
      before.getOutputStream().write(1);
      assertThat(there.getInputStream().read()).as("what was open stays so").isEqualTo(1);
    }
  }

  private static ServerSocket gate(Path files) throws IOException {
    return new Gate(
        new ServerSocket(0, BACKLOG, InetAddress.getByName(LOOPBACK)), guard(files, "maestro"));
  }

  private static SSLSocket call(Path files, String user, ServerSocket to) throws IOException {
    return (SSLSocket) guard(files, user).call(LOOPBACK, to.getLocalPort());
  }

  private static X509Certificate shown(SSLSocket socket) throws IOException {
    return (X509Certificate) socket.getSession().getPeerCertificates()[0];
  }

  private static String objection(Guard guard) {
    Optional<String> objection = guard.objection(LOOPBACK, gate.getLocalPort());
    assertThat(objection).isPresent();
    return objection.get();
  }

  private static Guard guard(Path files, String user) {
    return Guard.open(SiteSecurity.open(files), user);
  }

  private static Path files(String name, String site) {
    Path files = directory.resolve(name);
    SecureSite.make(
        files,
        site,
        List.of("localhost"),
        List.of("maestro", "container-robots"),
        List.of("lamp"),
        List.of("console"));
    return files;
  }

  private static Path copy(String name) {
    Path copy = directory.resolve(name);
    try (var files = Files.walk(site)) {
      for (Path file : files.toList()) {
        Files.copy(file, copy.resolve(site.relativize(file)), StandardCopyOption.COPY_ATTRIBUTES);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return copy;
  }

  private static Path replaced(Path file) throws IOException {
    Files.delete(file);
    return file;
  }

  private static void write(Path file, String text) {
    try {
      Files.writeString(file, text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
