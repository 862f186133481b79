package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** Whatever of a member's first words gets lost, the member comes in the end. */
class MissingWordsTest {
  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Topics topics = new Topics("home");
  private final WireFormat wire = new WireFormat();
  private final List<Duration> questions = new ArrayList<>();

  static Stream<Lossy.Loss> losses() {
    return Stream.of(
        new Lossy.Loss("description", 4),
        new Lossy.Loss("state", 4),
        new Lossy.Loss("status", 4),
        new Lossy.Loss("", 9));
  }

  @ParameterizedTest
  @MethodSource("losses")
  void whoeverSaidItIsAskedUntilItIsHeard(Lossy.Loss loss) {
    RatsMember anna = join("anna");
    Lossy transport = new Lossy(bus.client("cca"), loss);
    RatsLink link = BusLink.connect("cca", "home", transport, clock);
    assertThat(clock.runUntil(() -> isComplete(link, anna), Duration.ofMinutes(2))).isTrue();
    assertThat(transport.lost()).isEqualTo(loss.times());
  }

  @ParameterizedTest
  @MethodSource("losses")
  void soIsWhoIsWatchedAlone(Lossy.Loss loss) {
    RatsMember anna = join("anna");
    RatsLink link =
        BusLink.connectForWatched(
            "cca", "home", new Lossy(bus.client("cca"), loss), clock, SiteKind.OPEN);
    link.watch("anna", member -> {});
    assertThat(clock.runUntil(() -> isComplete(link, anna), Duration.ofMinutes(2))).isTrue();
  }

  /** Two thirds of all messages of the first minute, at random. */
  @Test
  void hundredsOfMembersComeThroughABadBroker() {
    for (int seed = 0; seed < 5; seed++) {
      SteppedClock itsClock = new SteppedClock();
      InProcessBus itsBus = new InProcessBus(itsClock);
      for (int number = 0; number < 120; number++) {
        TestDevice device = new TestDevice("m" + number, itsClock);
        RatsMember.start(device.profile(), List::of, itsBus.client("m" + number), "home", itsClock);
      }
      Random chance = new Random(seed);
      Transport bad =
          new Lossy(
              itsBus.client("cca"),
              message ->
                  itsClock.now().compareTo(Duration.ofMinutes(1)) < 0 && chance.nextInt(3) > 0);
      RatsLink link = BusLink.connect("cca", "home", bad, itsClock);
      assertThat(
              itsClock.runUntil(
                  () -> link.members().stream().filter(MissingWordsTest::isComplete).count() == 120,
                  Duration.ofMinutes(4)))
          .as("seed %d", seed)
          .isTrue();
    }
  }

  /** A broker sends it once more after a connect: nobody has said it since. */
  @Test
  void whatABrokerHasKeptIsNoNews() {
    TestDevice device = new TestDevice("anna", clock);
    RatsMember anna =
        RatsMember.start(
            device.profile(), () -> List.copyOf(device.facts), bus.client("anna"), "home", clock);
    BusLink link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    assertThat(clock.runUntil(() -> isComplete(link, anna), Duration.ofMinutes(1))).isTrue();
    clock.run(Duration.ofSeconds(5));
    long heard = known(link).statesHeard();
    bus.cut("cca");
    clock.run(Duration.ofSeconds(1));
    bus.mend("cca");
    clock.run(Duration.ofMillis(100));
    assertThat(known(link).statesHeard()).isEqualTo(heard);
    clock.run(Duration.ofSeconds(5));
    assertThat(known(link).statesHeard()).as("what it says when it is asked").isGreaterThan(heard);

    bus.cut("cca");
    device.facts.clear();
    anna.stateChanged();
    clock.run(Duration.ofSeconds(1));
    bus.mend("cca");
    clock.run(Duration.ofMillis(100));
    assertThat(known(link).state().orElseThrow().values()).isEmpty();
  }

  @Test
  void aStateThatIsClearedIsAskedForAgain() {
    RatsMember anna = join("anna");
    RatsLink link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    assertThat(clock.runUntil(() -> isComplete(link, anna), Duration.ofMinutes(1))).isTrue();
    Transport other = bus.client("other");
    other.open(Optional.empty(), new Unconcerned());
    clock.run(Duration.ofSeconds(1));
    other.publish(Publication.clearing(topics.state("anna")), failure -> {});
    clock.run(Duration.ofMillis(100));
    assertThat(known(link).state()).isEmpty();
    assertThat(clock.runUntil(() -> isComplete(link, anna), Duration.ofMinutes(1))).isTrue();
  }

  /** Whoever dies may be otherwise when it is back. */
  @Test
  void whatWasSaidBeforeALossDoesNotCountAfterIt() {
    RatsMember anna = join("anna");
    RatsLink link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    assertThat(clock.runUntil(() -> isComplete(link, anna), Duration.ofMinutes(1))).isTrue();
    anna.die();
    clock.run(Duration.ofSeconds(1));
    assertThat(known(link).phase()).isEqualTo(MemberStatus.Phase.LOST);
    assertThat(known(link).state()).isEmpty();
  }

  private static RatsLink.Member known(RatsLink link) {
    return link.members().iterator().next();
  }

  private static final class Unconcerned implements Transport.ConnectionListener {
    @Override
    public void connected() {}

    @Override
    public void lost(String reason) {}
  }

  @Test
  void whoNeverDescribesItselfIsAskedLaterAndLaterButNotForgotten() {
    Transport mute = bus.client("mute");
    mute.subscribe(topics.calls(), Transport.RetainedMessages.IGNORE, call -> heard(call, "mute"));
    mute.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            mute.publish(
                Publication.retained(
                    topics.status("mute"),
                    wire.encode(new MemberStatus("mute", MemberStatus.Phase.READY, "b"))),
                failure -> assertThat(failure).isEmpty());
          }

          @Override
          public void lost(String reason) {
            throw new AssertionError(reason);
          }
        });
    RatsLink link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    clock.run(Duration.ofHours(1));
    assertThat(questions).hasSizeBetween(60, 75);
    for (int number = 1; number < questions.size(); number++) {
      assertThat(questions.get(number).minus(questions.get(number - 1)))
          .isLessThanOrEqualTo(Duration.ofSeconds(61));
    }
    mute.publish(Publication.retained(topics.description("mute"), "{}".getBytes()), failure -> {});
    mute.die();
    mute.close();
    link.close();
    clock.run(Duration.ofMinutes(2));
    int asked = questions.size();
    clock.run(Duration.ofHours(1));
    assertThat(questions).hasSize(asked);
  }

  private void heard(Message message, String member) {
    Call call = wire.decodeCall(message.payload());
    if (call.feature().equals(ReservedFeature.DESCRIBE.word())
        && call.member().filter(member::equals).isPresent()) {
      questions.add(clock.now());
    }
  }

  private RatsMember join(String id) {
    RatsMember member =
        RatsMember.start(
            new TestDevice(id, clock).profile(), List::of, bus.client(id), "home", clock);
    clock.run(Duration.ofSeconds(1));
    return member;
  }

  private static boolean isComplete(RatsLink link, RatsMember member) {
    return link.members().stream()
        .anyMatch(known -> known.boot().equals(member.boot()) && isComplete(known));
  }

  private static boolean isComplete(RatsLink.Member member) {
    return member.phase() == MemberStatus.Phase.READY
        && member.description().isPresent()
        && member.state().isPresent();
  }
}
