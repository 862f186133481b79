package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Transport;

/** Members and controllers on a bus, for tests of the link; over each transport with its clock. */
abstract class LinkParty {

  final List<AutoCloseable> opened = new ArrayList<>();

  abstract Clock clock();

  /** A transport that is not open yet. */
  abstract Transport client(String id);

  abstract void stopBroker();

  abstract void restartBroker();

  /**
   * Waits until the condition holds, at most some minutes of simulated time, and fails if it does
   * not.
   */
  abstract void await(BooleanSupplier condition);

  @AfterEach
  void closeAll() throws Exception {
    for (AutoCloseable closeable : opened) {
      closeable.close();
    }
  }

  static RatsLink.Order order(
      String id, String boot, String feature, Map<String, Object> parameters) {
    return new RatsLink.Order(
        Optional.of(id),
        "anna",
        Optional.of(boot),
        feature,
        parameters,
        seconds(600),
        Optional.of("G1"));
  }

  static List<String> running(RatsLink link, String id) {
    return member(link, id).state().orElseThrow().running();
  }

  final RatsMember join(String id, String site) {
    return join(new TestDevice(id, clock()), site);
  }

  final RatsMember join(TestDevice device, String site) {
    String id = device.profile().id();
    RatsMember member =
        RatsMember.start(
            device.profile(), () -> List.copyOf(device.facts), client(id), site, clock());
    opened.add(member);
    return member;
  }

  final RatsLink connect(String id, String site) {
    RatsLink link = BusLink.connect(id, site, client(id), clock());
    opened.add(0, link);
    return link;
  }

  final RatsLink connectForWatched(String id, String site) {
    RatsLink link = BusLink.connectForWatched(id, site, client(id), clock(), SiteKind.OPEN);
    opened.add(0, link);
    return link;
  }

  static boolean usable(RatsLink link, String id) {
    return link.members().stream()
        .anyMatch(
            member ->
                member.id().equals(id)
                    && member.phase() == MemberStatus.Phase.READY
                    && member.description().isPresent()
                    && member.state().isPresent());
  }

  static RatsLink.Member member(RatsLink link, String id) {
    return link.members().stream()
        .filter(member -> member.id().equals(id))
        .findFirst()
        .orElseThrow();
  }

  static Duration seconds(int seconds) {
    return Duration.ofSeconds(seconds);
  }

  static void assertFailed(Result result, ErrorCode code) {
    assertThat(result.outcome()).isEqualTo(Outcome.FAILED);
    assertThat(result.error().orElseThrow().code()).isEqualTo(code);
  }

  static final class Listener implements RatsLink.CallListener {
    final List<Progress> progress = new CopyOnWriteArrayList<>();
    final List<Observation> observations = new CopyOnWriteArrayList<>();
    final List<Result> results = new CopyOnWriteArrayList<>();

    @Override
    public void progressed(Progress sign) {
      progress.add(sign);
    }

    @Override
    public void observed(Observation observation) {
      observations.add(observation);
    }

    @Override
    public void ended(Result result) {
      results.add(result);
    }

    boolean ended() {
      return !results.isEmpty();
    }

    Result only() {
      assertThat(results).hasSize(1);
      return results.get(0);
    }
  }
}
