package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Offer;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.Release;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/**
 * Impatience and acquiescence on the bus (Three-layered architecture, 3.2.1; M43, M44): who hears
 * of what another is at offers to do it when that is better, and never begins by itself; who fails
 * gives back.
 */
class TakeoverTest {

  private static final String SITE = "test";

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Carrier rose = new Carrier("rose");
  private final Carrier tim = new Carrier("tim");
  private final RatsLink link = BusLink.connect("cca", SITE, bus.client("cca"), clock);
  private final Heard heard = new Heard();
  private CallPolicy policy = CallPolicy.OPEN;

  @BeforeEach
  void join() {
    rose.price = 10;
    tim.price = 30;
  }

  private void begin() {
    rose.join();
    if (tim.member == null) {
      tim.join();
    }
    run(2);
    call("rose", Optional.of(new Call.Expectation(10, 10)));
    run(2);
  }

  private void ask(String member) {
    List<CostAnswer> answers = new ArrayList<>();
    link.cost(member, "carry", List.of(Map.of("object", "cup")), answers::addAll);
    run(1);
    assertThat(answers).hasSize(1);
  }

  @Test
  void whoHasBecomeCheaperThanWhatIsLeftOffersOnce() {
    begin();
    assertThat(heard.offers).isEmpty();

    tim.costs(4);
    tim.costs(3);

    assertThat(heard.offers).containsExactly("tim: carry for 4.0 in 4.0 s");
    assertThat(tim.begun).as("it is for the holder to decide").isZero();
    assertThat(rose.begun).isEqualTo(1);
  }

  @Test
  void whatItsHolderWasToldBeforeIsNotOffered() {
    tim.price = 4;
    tim.join();
    run(1);
    ask("tim");

    begin();
    tim.tells();
    assertThat(heard.offers).as("4 it was said to cost, and 4 it is").isEmpty();
    tim.costs(3.9);
    assertThat(heard.offers).as("a little cheaper than it was: still news").hasSize(1);
  }

  /** A plan has several steps: it is cheaper than told for one that is called long after. */
  @Test
  void whoHasBecomeCheaperBetweenItsPriceAndTheCallOffersAtTheCall() {
    tim.join();
    run(1);
    ask("tim");
    tim.costs(4);

    begin();
    assertThat(heard.offers).containsExactly("tim: carry for 4.0 in 4.0 s");
    int priced = tim.priced;
    call("rose", Optional.of(new Call.Expectation(3, 3)));
    run(1);
    assertThat(tim.priced).as("nothing has changed since it looked").isEqualTo(priced);
  }

  @Test
  void nothingIsPricedForACallThatGoesWell() {
    begin();
    run(40);

    assertThat(heard.results).hasSize(1);
    assertThat(tim.priced).isZero();
  }

  @Test
  void whatIsNearlyDoneIsLeftToItsDoer() {
    begin();
    run(5);
    tim.costs(4);
    assertThat(heard.offers).isEmpty();
  }

  @Test
  void whoWasBusyAndIsFreeOffers() {
    tim.price = 4;
    rose.join();
    tim.join();
    run(2);
    link.call(
        "tim", "carry", Map.of("object", "box"), Duration.ofMinutes(1), Optional.empty(), r -> {});
    run(1);
    call("rose", Optional.of(new Call.Expectation(20, 20)));
    run(2);
    assertThat(heard.offers).isEmpty();

    run(10);
    assertThat(heard.offers).containsExactly("tim: carry for 4.0 in 4.0 s");
  }

  @Test
  void whoIsLateByMoreThanAnotherNeedsIsOfferedHelp() {
    rose.neverEnds = true;
    tim.price = 12;
    begin();
    run(19);
    assertThat(heard.offers).isEmpty();
    run(3);
    assertThat(heard.offers).containsExactly("tim: carry for 12.0 in 12.0 s");
  }

  /** To find out why not can be a long search, once for each that hears of it. */
  @Test
  void whoCannotHelpIsNotAskedWhy() {
    rose.neverEnds = true;
    tim.able = false;
    begin();
    run(60);
    tim.tells();

    assertThat(tim.priced).isPositive();
    assertThat(tim.explained).isZero();
    assertThat(heard.offers).isEmpty();
  }

  /** There members do not read each other's states: who is late is told by the time alone. */
  @Test
  void onASecuredSiteTooWhoIsLateIsOfferedHelpOnce() {
    policy = new AllAllowed();
    rose.neverEnds = true;
    tim.price = 12;
    begin();
    run(19);
    assertThat(heard.offers).isEmpty();
    run(3);
    assertThat(heard.offers).containsExactly("tim: carry for 12.0 in 12.0 s");
    tim.tells();
    run(60);
    assertThat(heard.offers).hasSize(1);
  }

  @Test
  void onASecuredSiteTheHolderPassesOverOffersForWhatHasEnded() {
    policy = new AllAllowed();
    tim.price = 12;
    begin();
    run(40);
    assertThat(heard.results).hasSize(1);
    assertThat(heard.offers).isEmpty();
  }

  @Test
  void whatHasEndedIsForgotten() {
    tim.price = 12;
    begin();
    run(40);
    assertThat(heard.results).hasSize(1);
    tim.costs(1);
    assertThat(heard.offers).isEmpty();
  }

  @Test
  void whatIsCancelledOrNotAllowedOrNotPricedIsNotOffered() {
    policy =
        new CallPolicy() {
          @Override
          public boolean allows(String caller, String member, String feature) {
            return !feature.equals("carry") || !member.equals("tim");
          }

          @Override
          public boolean isSecured() {
            return true;
          }
        };
    begin();
    tim.costs(1);
    assertThat(heard.offers).as("tim may not be called for it").isEmpty();

    policy = CallPolicy.OPEN;
    call("rose", Optional.empty());
    run(1);
    tim.costs(0.5);
    assertThat(heard.offers).as("nobody says what it may cost").isEmpty();
  }

  @Test
  void aTaskGivenBackIsHeardOfBeforeItsOutcome() {
    rose.jamsAfterSeconds = Optional.of(3);
    begin();
    run(2);
    assertThat(heard.released).containsExactly("the gripper is jammed");
    assertThat(heard.results).isEmpty();

    run(3);
    assertThat(heard.results.get(0).outcome()).isEqualTo(Outcome.FAILED);
    assertThat(heard.results.get(0).error().orElseThrow().code())
        .isEqualTo(ErrorCode.HARDWARE_FAILURE);
  }

  @Test
  void nobodyGivesBackWhatAnotherIsAtNorOffersInAnothersName() {
    begin();
    Transport insider = bus.client("lamp");
    insider.open(Optional.empty(), new Unconcerned());
    run(1);
    tell(
        insider, "lamp", ReservedFeature.RELEASE, new Release(heard.callId, "forged").parameters());
    Map<String, Object> offer = new Offer(heard.callId, "carry", 0.1, 0.1).parameters();
    tell(insider, "tim", ReservedFeature.OFFER, offer);
    tell(insider, "lamp", ReservedFeature.OFFER, Map.of("task", heard.callId, "f", "carry"));
    tell(insider, "lamp", ReservedFeature.OFFER, new Offer("other", "carry", 1, 1).parameters());
    run(1);

    assertThat(heard.released).isEmpty();
    assertThat(heard.offers).isEmpty();
    insider.close();
  }

  private void tell(Transport lamp, String from, String feature, Map<String, Object> parameters) {
    Call told =
        new Call(
            "x-" + feature + parameters.size(),
            Optional.of("cca"),
            Optional.empty(),
            feature,
            parameters,
            Duration.ofSeconds(30),
            from,
            Optional.empty());
    lamp.publish(
        Publication.reliable(
            new Topics(SITE).call("lamp"), new WireFormat().encode(told), Optional.empty()),
        failure -> assertThat(failure).isEmpty());
  }

  private void call(String member, Optional<Call.Expectation> expected) {
    heard.callId =
        link.call(
                new RatsLink.Order(
                    Optional.empty(),
                    member,
                    Optional.empty(),
                    "carry",
                    Map.of("object", "cup"),
                    Duration.ofMinutes(2),
                    Optional.empty(),
                    Optional.of("G1"),
                    expected),
                heard)
            .callId();
  }

  private void run(int seconds) {
    clock.run(Duration.ofSeconds(seconds));
  }

  private static final class Heard implements RatsLink.CallListener {
    private final List<String> offers = new ArrayList<>();
    private final List<String> released = new ArrayList<>();
    private final List<Result> results = new ArrayList<>();
    private String callId = "";

    @Override
    public void offered(String member, Offer offer) {
      offers.add(
          "%s: %s for %s in %s s"
              .formatted(member, offer.feature(), offer.cost(), offer.seconds()));
    }

    @Override
    public void released(String reason) {
      released.add(reason);
    }

    @Override
    public void ended(Result result) {
      results.add(result);
    }
  }

  /** Carries things, in as many seconds as it costs. */
  private final class Carrier implements Procedure {
    private final String id;
    private double price;
    private int begun;
    private int told;
    private int priced;
    private int explained;
    private boolean able = true;
    private boolean neverEnds;
    private Optional<Integer> jamsAfterSeconds = Optional.empty();
    private RatsMember member;

    private Carrier(String id) {
      this.id = id;
    }

    private void join() {
      MemberProfile.Feature carry =
          new MemberProfile.Feature(
              "carry", Set.of("object"), Set.of("arm"), false, Optional.empty(), "busy", this);
      MemberProfile profile =
          new MemberProfile(
                  id,
                  "{}",
                  Set.of("standby", "busy"),
                  "standby",
                  Set.of("standby"),
                  MemberProfile.byId(List.of(carry)))
              .takingOver(Set.of("carry"));
      member =
          RatsMember.start(
              profile,
              () -> List.of("(told " + id + " " + told + ")"),
              bus.client(id),
              SITE,
              new Asking(),
              clock);
    }

    private void costs(double now) {
      price = now;
      tells();
    }

    private void tells() {
      clock.schedule(
          Duration.ZERO,
          id,
          () -> {
            told++;
            member.stateChanged();
          });
      clock.run(Duration.ofMillis(100));
    }

    @Override
    public void start(Execution execution) {
      begun++;
      execution.onCancel(safe -> clock.schedule(Duration.ofSeconds(2), id, safe));
      jamsAfterSeconds.ifPresent(
          after -> clock.schedule(Duration.ofSeconds(after), id, () -> jam(execution)));
      if (!neverEnds) {
        clock.schedule(
            Duration.ofMillis((long) (price * 1_000)), id, () -> execution.succeed(Map.of()));
      }
    }

    private void jam(Execution execution) {
      execution.giveBack(
          new RatsError(
              ErrorCode.HARDWARE_FAILURE,
              RatsError.Level.WARNING,
              "the gripper is jammed",
              Optional.empty(),
              List.of(),
              true));
    }

    @Override
    public CostAnswer cost(Map<String, Object> parameters) {
      explained++;
      return new CostAnswer(Optional.of(price), Optional.of(price), Optional.empty());
    }

    @Override
    public Optional<CostAnswer> costIfAble(Map<String, Object> parameters) {
      priced++;
      return able
          ? Optional.of(new CostAnswer(Optional.of(price), Optional.of(price), Optional.empty()))
          : Optional.empty();
    }
  }

  private static final class Unconcerned implements Transport.ConnectionListener {
    @Override
    public void connected() {
      // It speaks only.
    }

    @Override
    public void lost(String reason) {
      // It speaks only.
    }
  }

  private static final class AllAllowed implements CallPolicy {
    @Override
    public boolean allows(String caller, String member, String feature) {
      return true;
    }

    @Override
    public boolean isSecured() {
      return true;
    }
  }

  /** The policy as it is when asked. */
  private final class Asking implements CallPolicy {
    @Override
    public boolean allows(String caller, String called, String feature) {
      return policy.allows(caller, called, feature);
    }

    @Override
    public boolean isSecured() {
      return policy.isSecured();
    }
  }
}
