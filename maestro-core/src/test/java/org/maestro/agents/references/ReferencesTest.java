package org.maestro.agents.references;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.Words;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.SessionKey;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.SteppedClock;

/** Two agents, a registry and a forger on a wire that loses what it is told to. */
class ReferencesTest {
  private static final Duration TRANSIT = Duration.ofMillis(1);
  private static final Duration LOST = References.TIMING.lostAfter();
  private static final Duration PERIOD = References.TIMING.period();

  private final SteppedClock clock = new SteppedClock();
  private final Map<String, References> agents = new HashMap<>();
  private final List<String> sequence = new ArrayList<>();
  private final List<ACLMessage> heardByForger = new ArrayList<>();
  private final Set<String> blocked = new HashSet<>();
  private final Told told = new Told();
  private boolean registryIsThere = true;
  private Duration registryTakes = Duration.ZERO;

  /** What a holder is told. */
  private static final class Told implements Holder {
    private final List<String> reasons = new ArrayList<>();
    private Optional<Reference> reference = Optional.empty();
    private int lost;

    @Override
    public void referred(Reference its) {
      reference = Optional.of(its);
    }

    @Override
    public void refused(String reason) {
      reasons.add(reason);
    }

    @Override
    public void lost(Reference its, String reason) {
      lost++;
      reasons.add(reason);
    }

    Condition condition() {
      return reference.orElseThrow().condition();
    }
  }

  /** Of an agent on the wire. */
  private final class OnTheWire implements Post {
    private final AID self;

    OnTheWire(String name) {
      self = aid(name);
    }

    @Override
    public AID self() {
      return self;
    }

    @Override
    public AID registry() {
      return aid("supervisor");
    }

    @Override
    public void send(ACLMessage message) {
      message.setSender(self);
      carry(message);
    }

    @Override
    public Clock clock() {
      return clock;
    }

    @Override
    public void tell(Runnable action) {
      action.run();
    }
  }

  private static AID aid(String name) {
    return new AID(name + "@test", AID.ISGUID);
  }

  @BeforeEach
  void begin() {
    for (String name : List.of("tablet", "lamp")) {
      agents.put(name, new References(new OnTheWire(name)));
    }
  }

  private void carry(ACLMessage message) {
    String from = message.getSender().getLocalName();
    String to = ((AID) message.getAllReceiver().next()).getLocalName();
    if (blocked.contains(from + " " + to)) {
      return;
    }
    sequence.add(
        "%s %s %s"
            .formatted(
                ACLMessage.getPerformative(message.getPerformative()).toLowerCase(Locale.ROOT),
                from,
                to));
    clock.schedule(TRANSIT, to, () -> deliver(message, to));
  }

  private void deliver(ACLMessage message, String to) {
    if (agents.containsKey(to)) {
      assertThat(agents.get(to).takes(message)).isTrue();
    } else if (to.equals("forger")) {
      heardByForger.add(message);
    } else if (registryIsThere && to.equals("supervisor")) {
      clock.schedule(registryTakes, to, () -> passOn(message));
    }
  }

  private void passOn(ACLMessage message) {
    OnTheWire registry = new OnTheWire("supervisor");
    String agent = Wanted.read(first(message)).agent().orElseThrow();
    if (!agents.containsKey(agent)) {
      ACLMessage refuse = message.createReply();
      refuse.setPerformative(ACLMessage.REFUSE);
      refuse.setContent("(inform (:reason \"There is none.\"))");
      registry.send(refuse);
      return;
    }
    ACLMessage agree = message.createReply();
    agree.setPerformative(ACLMessage.AGREE);
    agree.setContent("(refer (:agent %s))".formatted(agent));
    registry.send(agree);
    ACLMessage passed = recruiting(ACLMessage.REQUEST, agent, message.getConversationId());
    passed.setContent("(refer (:asker \"tablet\"))");
    passed.addReplyTo(message.getSender());
    registry.send(passed);
  }

  private static Words first(ACLMessage message) {
    return Words.of(Words.parse(message.getContent()).get(0));
  }

  private static ACLMessage recruiting(int performative, String to, String conversation) {
    ACLMessage message = new ACLMessage(performative);
    message.addReceiver(aid(to));
    message.setProtocol(FIPANames.InteractionProtocol.FIPA_RECRUITING);
    message.setConversationId(conversation);
    return message;
  }

  private void refer() {
    agents.get("tablet").ask(Wanted.agent("lamp"), told);
    pass(Duration.ofMillis(100));
  }

  private void pass(Duration time) {
    boolean[] passed = {false};
    clock.schedule(time, "test", () -> passed[0] = true);
    clock.runUntil(() -> passed[0], time.plusSeconds(1));
  }

  private void passUntil(Predicate<Told> isSo, Duration most) {
    assertThat(clock.runUntil(() -> isSo.test(told), most)).isTrue();
  }

  @Test
  void theRequestIsPassedOnAndTheOneAskedForAnswersItself() {
    refer();

    assertThat(sequence)
        .containsExactly(
            "proxy tablet supervisor",
            "agree supervisor tablet",
            "request supervisor lamp",
            "inform lamp tablet",
            "request tablet lamp",
            "inform lamp tablet");
    assertThat(told.reference.orElseThrow().agent().getLocalName()).isEqualTo("lamp");
    assertThat(agents.get("lamp").holders()).containsExactly("tablet");
  }

  @Test
  void whoAnswersBeforeTheRegistryHasNamedHimIsHeardWhenItHas() {
    AID lamp = aid("lamp");
    agents.get("tablet").ask(Wanted.agent("lamp"), told);
    registryTakes = Duration.ofSeconds(1);
    ACLMessage early = recruiting(ACLMessage.INFORM, "tablet", "tablet-refers-1");
    early.setSender(lamp);
    early.setContent("(refer (:agent lamp) (:key \"%s\"))".formatted(SessionKey.fresh().write()));
    carry(early);
    pass(Duration.ofMillis(500));
    assertThat(told.reference).isEmpty();

    pass(Duration.ofSeconds(1));
    assertThat(told.reference).isPresent();
  }

  @Test
  void whoIsNotTheNamedOneIsNotReferredTo() {
    agents.get("tablet").ask(Wanted.agent("lamp"), told);
    blocked.add("supervisor lamp");
    pass(Duration.ofMillis(100));
    ACLMessage forged = recruiting(ACLMessage.INFORM, "tablet", "tablet-refers-1");
    forged.setSender(aid("forger"));
    forged.setContent("(refer (:agent lamp) (:key \"%s\"))".formatted(SessionKey.fresh().write()));
    carry(forged);
    pass(Duration.ofMinutes(1));

    assertThat(told.reference).isEmpty();
    assertThat(told.reasons).containsExactly("Nobody has answered within 10 s.");
  }

  @Test
  void withoutTheRegistryReferencesGoOn() {
    refer();
    registryIsThere = false;
    pass(Duration.ofMinutes(5));

    assertThat(told.lost).isZero();
    assertThat(told.condition()).isEqualTo(Condition.ALIVE);
    assertThat(agents.get("lamp").holders()).containsExactly("tablet");
  }

  @Test
  void whatDoesNotGetThereIsAnErrorForTheSenderAndTheReceiverTimesOut() {
    refer();
    blocked.add("tablet lamp");
    pass(LOST.minus(PERIOD));
    assertThat(told.condition()).isEqualTo(Condition.SUSPECTED);
    assertThat(told.lost).isZero();
    assertThat(agents.get("lamp").holders()).isNotEmpty();

    passUntil(
        its -> its.lost == 1 && agents.get("lamp").holders().isEmpty(), PERIOD.multipliedBy(3));
    assertThat(told.reasons).containsExactly("lamp has confirmed no sign of life for 10 s.");
    assertThat(told.condition()).isEqualTo(Condition.LOST);
  }

  @Test
  void whatIsNotConfirmedIsAnErrorForTheSenderAndTheReceiverTimesOutAfterwards() {
    refer();
    blocked.add("lamp tablet");
    passUntil(its -> its.lost == 1, LOST.plus(PERIOD.multipliedBy(2)));
    assertThat(agents.get("lamp").holders()).as("it has heard all that was sent").isNotEmpty();

    passUntil(its -> agents.get("lamp").holders().isEmpty(), LOST.plus(PERIOD.multipliedBy(2)));
    assertThat(told.lost).isEqualTo(1);
  }

  @Test
  void whatIsLostForAMomentOnlyHarmsNothing() {
    refer();
    blocked.addAll(List.of("tablet lamp", "lamp tablet"));
    pass(LOST.minus(PERIOD.multipliedBy(2)));
    blocked.clear();
    pass(Duration.ofMinutes(1));

    assertThat(told.lost).isZero();
    assertThat(told.condition()).isEqualTo(Condition.ALIVE);
  }

  @Test
  void aForgedSignOfLifeIsNotBelieved() {
    refer();
    blocked.add("tablet lamp");
    SessionKey forged = SessionKey.fresh();
    for (int number = 10; number < 20; number++) {
      ACLMessage beat = recruiting(ACLMessage.REQUEST, "lamp", "tablet-refers-1");
      beat.setSender(aid("tablet"));
      beat.setContent(
          Words.print(
              Words.content(
                  "beat",
                  Words.named(
                      "sealed",
                      Words.text(
                          forged
                              .seal(SessionKey.Kind.BEAT, number, SessionKey.fresh().write())
                              .write())))));
      deliver(beat, "lamp");
      pass(PERIOD);
    }

    assertThat(agents.get("lamp").holders()).as("it has timed out all the same").isEmpty();
  }

  @Test
  void whoTakesASignOfLifeOfAnotherForHisOwnIsRefused() {
    refer();
    ACLMessage beat = recruiting(ACLMessage.REQUEST, "lamp", "tablet-refers-1");
    beat.setSender(aid("forger"));
    beat.setContent("(beat (:sealed \"x\"))");
    deliver(beat, "lamp");
    pass(Duration.ofMillis(10));

    assertThat(heardByForger)
        .singleElement()
        .satisfies(
            answer -> {
              assertThat(answer.getPerformative()).isEqualTo(ACLMessage.REFUSE);
              assertThat(answer.getContent()).contains("lamp knows of no reference of yours");
            });
  }

  @Test
  void whoDoesNotComeThroughTheRegistryIsRefused() {
    ACLMessage request = recruiting(ACLMessage.REQUEST, "lamp", "forger-refers-1");
    request.setSender(aid("forger"));
    request.addReplyTo(aid("forger"));
    request.setContent("(refer (:asker \"tablet\"))");
    deliver(request, "lamp");
    pass(Duration.ofMillis(10));

    assertThat(heardByForger)
        .singleElement()
        .extracting(ACLMessage::getContent)
        .asString()
        .contains("Nobody refers to lamp but through the supervisor");
    assertThat(agents.get("lamp").holders()).isEmpty();
  }

  @Test
  void aReferenceThatIsDroppedIsOverForBoth() {
    refer();
    agents.get("tablet").drop(told.reference.orElseThrow());
    pass(Duration.ofMillis(10));

    assertThat(agents.get("lamp").holders()).isEmpty();
    assertThat(told.lost).isZero();
  }

  @Test
  void whatIsNeededAllTheTimeIsAskedForAgainAndTheFirstChoiceIsTakenWhenItComes() {
    List<String> had = new ArrayList<>();
    KeptReference kept =
        agents
            .get("tablet")
            .keep(
                List.of(Wanted.agent("candle"), Wanted.agent("lamp")),
                its -> had.add(its.agent().map(AID::getLocalName).orElse("none")));
    pass(Duration.ofMinutes(1));
    assertThat(had).containsExactly("lamp");

    agents.put("candle", new References(new OnTheWire("candle")));
    pass(Duration.ofSeconds(15));
    assertThat(had).containsExactly("lamp", "candle");
    assertThat(agents.get("lamp").holders()).isEmpty();

    agents.remove("candle").end();
    pass(LOST.plus(PERIOD.multipliedBy(2)));
    assertThat(had).containsExactly("lamp", "candle", "none", "lamp");
    assertThat(kept.reason()).isEqualTo("supervisor says: There is none.");
  }
}
