package org.maestro.rats.security;

import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.MemberCalls;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.link.SiteKind;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.Credentials;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Transport;

/** A door, a camera, a lamp and a controller of a secured site, over some broker. */
final class SecuredSite implements AutoCloseable {

  static final String SITE = "home";

  final SiteSecurity security;
  private final TestBroker broker;
  private final PacedClock clock = new PacedClock(1);
  private final List<Runnable> opened = new ArrayList<>();

  SecuredSite(Path files, TestBroker broker) {
    this.security = SiteSecurity.open(files);
    this.broker = broker;
    broker.start();
  }

  static Path files(Path directory) {
    SecureSite.make(
        directory,
        SITE,
        List.of("127.0.0.1", "localhost"),
        List.of("cca"),
        List.of("door", "cam-1.a", "lamp"));
    return directory;
  }

  URI uri() {
    return broker.uri();
  }

  TestDevice join(Credentials credentials) {
    TestDevice device = new TestDevice(credentials.user(), clock);
    start(device, new PahoTransport(uri(), credentials));
    return device;
  }

  /** One that calls others, too. */
  MemberCalls joinAsking(Credentials credentials) {
    MemberCalls calls =
        new MemberCalls(credentials.user(), SITE, new PahoTransport(uri(), credentials), clock);
    start(new TestDevice(credentials.user(), clock), calls.transport());
    return calls;
  }

  private void start(TestDevice device, Transport transport) {
    RatsMember member =
        RatsMember.start(device.profile(), List::of, transport, SITE, security.rules(), clock);
    opened.add(0, member::close);
  }

  RatsLink connect(Credentials credentials) {
    RatsLink link =
        BusLink.connect(
            credentials.user(),
            SITE,
            new PahoTransport(uri(), credentials),
            clock,
            SiteKind.SECURED);
    opened.add(0, link::close);
    return link;
  }

  PacedClock clock() {
    return clock;
  }

  static boolean isReady(RatsLink link, String id) {
    return link.members().stream()
        .anyMatch(
            member ->
                member.id().equals(id)
                    && member.phase() == MemberStatus.Phase.READY
                    && member.description().isPresent()
                    && member.state().isPresent());
  }

  static void await(BooleanSupplier condition) {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(5))
        .atMost(Duration.ofSeconds(30))
        .until(condition::getAsBoolean);
  }

  @Override
  public void close() {
    opened.forEach(Runnable::run);
    clock.close();
    broker.stop();
  }
}
