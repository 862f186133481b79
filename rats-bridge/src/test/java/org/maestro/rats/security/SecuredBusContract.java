package org.maestro.rats.security;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.rats.security.SecuredSite.await;
import static org.maestro.rats.security.SecuredSite.isReady;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.IOException;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.net.ssl.SSLSocket;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.link.MemberCalls;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.ConnectionTester;
import org.maestro.rats.transport.Credentials;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.slf4j.LoggerFactory;

/** What a site does once it is secured, over any broker that uses its files. */
abstract class SecuredBusContract {

  @TempDir Path directory;

  abstract TestBroker byPassword(Path files);

  abstract TestBroker byCertificate(Path files);

  @Test
  void itsUsersWorkByPassword() {
    Path files = SecuredSite.files(directory);
    try (SecuredSite site = new SecuredSite(files, byPassword(files))) {
      worksFor(site, site.security::password);
    }
  }

  @Test
  void itsUsersWorkByCertificate() {
    Path files = SecuredSite.files(directory);
    try (SecuredSite site = new SecuredSite(files, byCertificate(files))) {
      worksFor(site, site.security::certificate);
    }
  }

  /** As the console of a site has it. */
  @Test
  void anObserverHearsEverythingAndSaysNothing() {
    Path files = SecuredSite.files(directory);
    SecureSite.in(files)
        .make(
            new SiteUsers(
                SecuredSite.SITE,
                List.of("127.0.0.1"),
                new TreeSet<>(),
                new TreeSet<>(),
                new TreeSet<>(Set.of("observer")),
                new TreeSet<>(),
                new TreeMap<>()));
    Topics topics = new Topics(SecuredSite.SITE);
    List<String> heard = new CopyOnWriteArrayList<>();
    List<Boolean> taken = new CopyOnWriteArrayList<>();
    try (SecuredSite site = new SecuredSite(files, byPassword(files))) {
      PahoTransport observer = new PahoTransport(site.uri(), site.security.password("observer"));
      observer.subscribe(
          "rats/1/" + SecuredSite.SITE + "/#",
          Transport.RetainedMessages.SEND,
          message -> heard.add(message.topic()));
      observer.open(
          Optional.empty(),
          new Transport.ConnectionListener() {
            @Override
            public void connected() {
              for (String topic :
                  List.of(topics.call("observer"), topics.call("cca"), topics.status("observer"))) {
                observer.publish(
                    Publication.reliable(
                        topic, "{}".getBytes(UTF_8), Optional.of(Duration.ofSeconds(30))),
                    failure -> taken.add(failure.isEmpty()));
              }
            }

            @Override
            public void lost(String reason) {
              // It tries again.
            }
          });
      try {
        TestDevice door = site.join(site.security.password("door"));
        RatsLink cca = site.connect(site.security.password("cca"));
        await(() -> isReady(cca, "door"));
        cca.call("door", "echo", Map.of(), Duration.ofSeconds(30), Optional.empty(), new Heard());
        await(
            () ->
                heard.containsAll(
                    List.of(
                        topics.call("cca"),
                        topics.result("cca", "door"),
                        topics.status("door"),
                        topics.state("door"))));
        await(() -> taken.size() >= 3);
        assertThat(taken).doesNotContain(true);
        assertThat(heard).doesNotContain(topics.call("observer"), topics.status("observer"));
        assertThat(door.log).hasSize(1);
      } finally {
        observer.close();
      }
    }
  }

  @Test
  void whoIsNotLetInIsToldWhy() {
    Path files = SecuredSite.files(directory);
    SiteSecurity other = SiteSecurity.open(SecuredSite.files(directory.resolve("other")));
    try (SecuredSite site = new SecuredSite(files, byPassword(files))) {
      ConnectionTester door = new ConnectionTester(site.uri(), Duration.ofSeconds(20));
      Credentials right = site.security.password("cca");
      Credentials guessed = new Credentials("cca", Optional.of("guessed"), right.tls());

      assertThat(door.objection(right)).isEmpty();
      assertThat(door.objection(guessed))
          .get()
          .asString()
          .containsAnyOf("Not authorized", "Bad User Name or Password");
      assertThat(door.objection(other.password("cca")))
          .get()
          .asString()
          .startsWith("its certificate is not of the site's CA");
    }
  }

  /** What everybody on this bus may read of a member, and what it logs. */
  @Test
  void nobodyTellsASecret() {
    Path files = SecuredSite.files(directory);
    Logger root = (Logger) LoggerFactory.getLogger(Logger.ROOT_LOGGER_NAME);
    ListAppender<ILoggingEvent> log = new ListAppender<>();
    Logger own = (Logger) LoggerFactory.getLogger("org.maestro.rats");
    Level former = own.getLevel();
    log.start();
    root.addAppender(log);
    own.setLevel(Level.DEBUG);
    List<String> told = new CopyOnWriteArrayList<>();
    try (SecuredSite site = new SecuredSite(files, byPassword(files))) {
      site.join(site.security.password("door"));
      // The broker may lose what is retained to whoever subscribes while it is published.
      try (RatsLink link = site.connect(site.security.password("cca"))) {
        await(() -> isReady(link, "door"));
      }
      PahoTransport witness = new PahoTransport(site.uri(), site.security.password("cca"));
      for (String filter : List.of("rats/1/home/member/#", "rats/1/home/call/#")) {
        witness.subscribe(
            filter,
            Transport.RetainedMessages.SEND,
            message -> told.add(message.topic() + new String(message.payload(), UTF_8)));
      }
      outcome(witness, () -> told.stream().filter(text -> text.contains("door/")).count() >= 3);
    } finally {
      own.setLevel(former);
      root.detachAppender(log);
    }
    List<String> secrets =
        List.of("door", "cca").stream()
            .map(id -> SiteSecurity.open(files).password(id).password().orElseThrow())
            .toList();
    List<String> said =
        Stream.concat(
                told.stream(),
                List.copyOf(log.list).stream().map(ILoggingEvent::getFormattedMessage))
            .toList();
    assertThat(said).hasSizeGreaterThan(2);
    secrets.forEach(secret -> assertThat(said).noneMatch(text -> text.contains(secret)));
  }

  private static void worksFor(SecuredSite site, Function<String, Credentials> credentials) {
    site.join(credentials.apply("cam-1.a"));
    TestDevice door = site.join(credentials.apply("door"));
    RatsLink link = site.connect(credentials.apply("cca"));
    await(() -> isReady(link, "cam-1.a") && isReady(link, "door"));
    Heard watch = new Heard();
    RatsLink.CallHandle watching =
        link.call(
            "cam-1.a",
            "watch",
            Map.of("object", "x"),
            Duration.ofSeconds(30),
            Optional.empty(),
            watch);
    Heard echo = new Heard();
    link.call("door", "echo", Map.of("a", 1), Duration.ofSeconds(30), Optional.empty(), echo);
    List<List<CostAnswer>> prices = new CopyOnWriteArrayList<>();
    link.cost("door", "drive", List.of(Map.of()), prices::add);
    await(() -> !watch.observations.isEmpty() && !echo.results.isEmpty() && !prices.isEmpty());
    watching.cancel();
    await(() -> !watch.results.isEmpty());
    assertThat(watch.results.get(0).outcome()).isEqualTo(Outcome.CANCELED);
    assertThat(echo.results.get(0).values()).isEqualTo(Map.of("a", 1));
    assertThat(prices.get(0).get(0).cost()).contains(2.5);
    assertThat(door.log).hasSize(1);
    // A member may be called by another only as the rules say.
    Result refused = callAsMember(site, credentials.apply("lamp"), "door", "echo");
    assertThat(refused.outcome()).isEqualTo(Outcome.REJECTED);
    assertThat(refused.error().orElseThrow().code()).isEqualTo(ErrorCode.NOT_AUTHORISED);
    assertThat(door.log).hasSize(1);
  }

  private static Result callAsMember(
      SecuredSite site, Credentials credentials, String member, String feature) {
    WireFormat wire = new WireFormat();
    Topics topics = new Topics(SecuredSite.SITE);
    List<Result> results = new CopyOnWriteArrayList<>();
    PahoTransport transport = new PahoTransport(site.uri(), credentials);
    transport.subscribe(
        topics.results(credentials.user()),
        Transport.RetainedMessages.IGNORE,
        message -> results.add(wire.decodeResult(message.payload())));
    Call call =
        new Call(
            "m1",
            Optional.of(member),
            Optional.empty(),
            feature,
            Map.of(),
            Duration.ofSeconds(30),
            credentials.user(),
            Optional.empty());
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            transport.publish(
                Publication.reliable(
                    topics.call(credentials.user()),
                    wire.encode(call),
                    Optional.of(call.timeout())),
                failure -> assertThat(failure).isEmpty());
          }

          @Override
          public void lost(String reason) {
            // It tries again.
          }
        });
    await(() -> !results.isEmpty());
    transport.close();
    return results.get(0);
  }

  /** Over the connection on which it is called: the broker would let it have no other. */
  @Test
  void aMemberAsksOthersAsTheRulesSay() {
    Path files = SecuredSite.files(directory);
    allow(files, "allow cca * *", "allow lamp door echo", "allow lamp door $cost");
    try (SecuredSite site = new SecuredSite(files, byPassword(files))) {
      TestDevice door = site.join(site.security.password("door"));
      site.join(site.security.password("cam-1.a"));
      MemberCalls lamp = site.joinAsking(site.security.password("lamp"));
      RatsLink link = site.connect(site.security.password("cca"));
      await(() -> isReady(link, "cam-1.a") && isReady(link, "door") && isReady(link, "lamp"));
      List<CostAnswer> prices = new CopyOnWriteArrayList<>();
      lamp.cost("door", "drive", List.of(Map.of("to", "b")), prices::addAll);
      Heard allowed = new Heard();
      lamp.call("door", "echo", Map.of("a", 2), Duration.ofSeconds(30), allowed);
      Heard refused = new Heard();
      lamp.call("cam-1.a", "echo", Map.of(), Duration.ofSeconds(30), refused);
      Heard asked = new Heard();
      link.call("lamp", "echo", Map.of(), Duration.ofSeconds(30), Optional.empty(), asked);
      await(() -> !allowed.results.isEmpty() && !refused.results.isEmpty());
      await(() -> !prices.isEmpty() && !asked.results.isEmpty());

      assertThat(prices.get(0).cost()).contains(2.5);
      assertThat(allowed.results.get(0).values()).isEqualTo(Map.of("a", 2));
      assertThat(refused.results.get(0).error().orElseThrow().code())
          .isEqualTo(ErrorCode.NOT_AUTHORISED);
      assertThat(asked.results.get(0).outcome()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(door.log).hasSize(1);
    }
  }

  /** ADE, 3.1 (A28): no process is started again. */
  @Test
  void aRightThatIsTakenAwayIsGoneAtOnceAndEndsWhatRunsByIt() {
    Path files = SecuredSite.files(directory);
    allow(files, "allow cca door *");
    try (SecuredSite site = new SecuredSite(files, byPassword(files))) {
      site.join(site.security.password("door"));
      RatsLink cca = site.connect(site.security.password("cca"));
      await(() -> isReady(cca, "door"));
      Heard watching = new Heard();
      call(cca, "watch", Map.of("object", "cup"), watching);
      assertThat(outcome(cca).outcome()).isEqualTo(Outcome.SUCCEEDED);

      allow(files, "allow cca dor *");
      assertThat(outcome(cca).outcome())
          .as("a wrong file leaves the rules as they are")
          .isEqualTo(Outcome.SUCCEEDED);

      allow(files, "allow lamp door *");
      Result refused = outcome(cca);
      assertThat(refused.outcome()).isEqualTo(Outcome.REJECTED);
      assertThat(refused.error().orElseThrow().code()).isEqualTo(ErrorCode.NOT_AUTHORISED);
      await(() -> !watching.results.isEmpty());
      assertThat(watching.results.get(0).outcome()).isEqualTo(Outcome.CANCELED);
      assertThat(watching.results.get(0).error().orElseThrow().code())
          .isEqualTo(ErrorCode.NOT_AUTHORISED);

      allow(files, "allow @controllers * echo");
      assertThat(outcome(cca).outcome()).isEqualTo(Outcome.SUCCEEDED);
    }
  }

  private static Result outcome(RatsLink caller) {
    Heard heard = new Heard();
    call(caller, "echo", Map.of(), heard);
    await(() -> !heard.results.isEmpty());
    return heard.results.get(0);
  }

  private static void call(
      RatsLink caller, String feature, Map<String, Object> parameters, Heard heard) {
    caller.call("door", feature, parameters, Duration.ofSeconds(30), Optional.empty(), heard);
  }

  private static void allow(Path files, String... lines) {
    PrivateFiles.write(files.resolve("rules.txt"), String.join("\n", lines) + "\n");
  }

  @Test
  void nobodyElseGetsIn() {
    Path files = SecuredSite.files(directory);
    try (SecuredSite site = new SecuredSite(files, byPassword(files))) {
      Credentials right = site.security.password("lamp");
      assertThat(outcome(new PahoTransport(site.uri(), right))).isEqualTo("connected");
      Credentials wrong = new Credentials("lamp", Optional.of("guessed"), right.tls());
      assertThat(outcome(new PahoTransport(site.uri(), wrong))).startsWith("lost");
      Credentials stranger = new Credentials("rose", right.password(), right.tls());
      assertThat(outcome(new PahoTransport(site.uri(), stranger))).startsWith("lost");
      Credentials anonymous = new Credentials("lamp", Optional.empty(), right.tls());
      assertThat(outcome(new PahoTransport(site.uri(), anonymous))).startsWith("lost");
      assertThat(outcome(new PahoTransport(site.uri(), "lamp")))
          .as("without TLS")
          .startsWith("lost");
      Path other = SecuredSite.files(directory.resolve("other"));
      Credentials otherCa =
          new Credentials(
              "lamp", right.password(), SiteSecurity.open(other).password("lamp").tls());
      assertThat(outcome(new PahoTransport(site.uri(), otherCa)))
          .as("to a broker that another authority vouches for")
          .startsWith("lost");
    }
  }

  /** Neither the broker nor anybody else is started again. */
  @Test
  void whoIsTakenOutOfTheSiteIsCutOffAndComesInNoMore() {
    Path files = SecuredSite.files(directory);
    TestBroker broker = byPassword(files);
    try (SecuredSite site = new SecuredSite(files, broker)) {
      takenOut(
          site, files, id -> SiteSecurity.open(files).password(id), broker::tellOfChanges, true);
    }
  }

  @Test
  void soIsWhoCameByItsCertificate() {
    Path files = SecuredSite.files(directory);
    TestBroker broker = byCertificate(files);
    try (SecuredSite site = new SecuredSite(files, broker)) {
      takenOut(
          site,
          files,
          id -> SiteSecurity.open(files).certificate(id),
          () -> tellOfRevokedCertificates(broker),
          othersStayWhenCertificatesAreRevoked());
    }
  }

  /** What a broker needs to know of certificates that were taken back. */
  void tellOfRevokedCertificates(TestBroker broker) {
    broker.tellOfChanges();
  }

  boolean othersStayWhenCertificatesAreRevoked() {
    return true;
  }

  private static void takenOut(
      SecuredSite site,
      Path files,
      Function<String, Credentials> credentials,
      Runnable telling,
      boolean othersStay) {
    Credentials former = credentials.apply("lamp");
    Kept lamp = new Kept(site, former);
    Kept door = new Kept(site, credentials.apply("door"));
    try (lamp;
        door) {
      await(() -> lamp.connects > 0 && door.connects > 0);

      SecureSite.in(files).revoke(List.of("lamp"));
      telling.run();
      await(() -> lamp.losses > 0);
      int before = lamp.connects;
      assertThat(outcome(new PahoTransport(site.uri(), former))).startsWith("lost");
      assertThat(lamp.connects).isEqualTo(before);
      assertThat(!othersStay || door.losses == 0).isTrue();
    }
    SecureSite.make(files, SecuredSite.SITE, List.of("127.0.0.1"), List.of(), List.of("lamp"));
    telling.run();
    await(
        () ->
            outcome(new PahoTransport(site.uri(), credentials.apply("lamp"))).equals("connected"));
    assertThat(outcome(new PahoTransport(site.uri(), former)))
        .as("what the former one of that name had")
        .startsWith("lost");
  }

  @Test
  void theBrokerShowsTheCertificateThatItWasGivenWhileItRuns() {
    Path files = SecuredSite.files(directory);
    TestBroker broker = byPassword(files);
    try (SecuredSite site = new SecuredSite(files, broker);
        Kept door = new Kept(site, site.security.password("door"))) {
      await(() -> door.connects > 0);
      String first = shown(site);

      SecureSite.in(files).renew(List.of("lamp"));
      broker.tellOfChanges();
      String second =
          Pem.certificate(files.resolve("broker/certificate.pem")).getSerialNumber().toString();
      await(() -> shown(site).equals(second));
      assertThat(second).isNotEqualTo(first);
      assertThat(door.losses).isZero();
      assertThat(outcome(new PahoTransport(site.uri(), site.security.password("lamp"))))
          .isEqualTo("connected");
    }
  }

  /** The number of the certificate that the broker shows to who comes now. */
  private static String shown(SecuredSite site) {
    try (SSLSocket socket =
        (SSLSocket)
            site.security
                .password("cca")
                .tls()
                .getSocketFactory()
                .createSocket(site.uri().getHost(), site.uri().getPort())) {
      socket.setSoTimeout(10_000);
      socket.startHandshake();
      return ((X509Certificate) socket.getSession().getPeerCertificates()[0])
          .getSerialNumber()
          .toString();
    } catch (IOException between) {
      return "none: " + between.getMessage();
    }
  }

  /** A connection that is made again whenever it is lost. */
  static final class Kept implements AutoCloseable {
    private final PahoTransport transport;
    volatile int connects;
    volatile int losses;

    Kept(SecuredSite site, Credentials credentials) {
      transport = new PahoTransport(site.uri(), credentials);
      transport.open(
          Optional.empty(),
          new Transport.ConnectionListener() {
            @Override
            public void connected() {
              connects++;
            }

            @Override
            public void lost(String reason) {
              losses++;
            }
          });
    }

    @Override
    public void close() {
      transport.die();
    }
  }

  private static String outcome(PahoTransport transport) {
    return outcome(transport, () -> true);
  }

  private static String outcome(PahoTransport transport, BooleanSupplier also) {
    List<String> told = new CopyOnWriteArrayList<>();
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            told.add("connected");
          }

          @Override
          public void lost(String reason) {
            told.add("lost: " + reason);
          }
        });
    try {
      await(() -> !told.isEmpty() && also.getAsBoolean());
    } finally {
      transport.die();
    }
    return told.get(0);
  }

  static final class Heard implements RatsLink.CallListener {
    final List<Observation> observations = new CopyOnWriteArrayList<>();
    final List<Result> results = new CopyOnWriteArrayList<>();

    @Override
    public void observed(Observation observation) {
      observations.add(observation);
    }

    @Override
    public void ended(Result result) {
      results.add(result);
    }
  }
}
