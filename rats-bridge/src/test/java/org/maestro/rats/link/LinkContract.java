package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Transport;

/** Link and members from end to end; run over each transport with its clock. */
abstract class LinkContract {

  private final List<AutoCloseable> opened = new ArrayList<>();

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

  @Test
  void knowsMembersThatCameBeforeAndAfter() {
    join("anna", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    List<String> changes = new CopyOnWriteArrayList<>();
    link.watch(member -> changes.add(member.id() + " " + member.phase()));
    RatsMember berta = join("berta", "home");
    await(() -> usable(link, "berta"));
    assertThat(link.members()).extracting(RatsLink.Member::id).containsExactly("anna", "berta");
    assertThat(changes.get(0)).isEqualTo("anna READY");
    assertThat(member(link, "berta").boot()).isEqualTo(berta.boot());
    assertThat(member(link, "berta").description()).contains("{\"@id\":\"berta\"}");
    assertThat(member(link, "berta").state().orElseThrow().values())
        .containsExactly("(level lamp 0)");
    berta.close();
    await(() -> link.members().size() == 1);
    assertThat(changes).contains("berta DISCONNECTED").doesNotContain("berta LOST");
  }

  @Test
  void callsOneMemberAndGetsOneResult() {
    join("anna", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener first = new Listener();
    Listener second = new Listener();
    link.call("anna", "drive", Map.of("to", "a"), seconds(600), Optional.of("G1"), first);
    link.call("anna", "echo", Map.of("a", 1), seconds(600), Optional.empty(), second);
    await(() -> first.ended() && second.ended());
    assertThat(first.only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(second.only().values()).isEqualTo(Map.of("a", 1));
    assertThat(first.progress)
        .extracting(Progress::kind)
        .containsExactly(Progress.Kind.ACCEPTED, Progress.Kind.STARTED);
  }

  @Test
  void failsCallsOfMembersThatAreNotThere() {
    RatsLink link = connect("cca", "home");
    Listener listener = new Listener();
    link.call("nobody", "echo", Map.of(), seconds(600), Optional.empty(), listener);
    await(listener::ended);
    assertFailed(listener.only(), ErrorCode.MEMBER_LOST);
  }

  @Test
  void failsCallsOfMembersThatDie() {
    RatsMember anna = join("anna", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener listener = new Listener();
    link.call("anna", "watch", Map.of("object", "Cup"), seconds(600), Optional.empty(), listener);
    await(() -> !listener.observations.isEmpty());
    anna.die();
    await(listener::ended);
    assertFailed(listener.only(), ErrorCode.MEMBER_LOST);
    assertThat(member(link, "anna").phase()).isEqualTo(MemberStatus.Phase.LOST);
    join("anna", "home");
    await(() -> usable(link, "anna"));
    Listener again = new Listener();
    link.call("anna", "echo", Map.of(), seconds(600), Optional.empty(), again);
    await(again::ended);
    assertThat(again.only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(listener.results).hasSize(1);
  }

  @Test
  void streamsUntilItCancels() {
    join("anna", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener listener = new Listener();
    RatsLink.CallHandle call =
        link.call("anna", "watch", Map.of("object", "Cup"), seconds(5), Optional.empty(), listener);
    await(() -> listener.observations.size() >= 7);
    assertThat(listener.results).as("t ended when it was established").isEmpty();
    assertThat(listener.observations).extracting(Observation::id).containsOnly(call.callId());
    call.cancel();
    await(listener::ended);
    assertThat(listener.only().outcome()).isEqualTo(Outcome.CANCELED);
    call.cancel();
  }

  @Test
  void timesOut() {
    join("anna", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener first = new Listener();
    Listener second = new Listener();
    link.call("anna", "drive", Map.of("to", "a"), seconds(200), Optional.empty(), first);
    link.call("anna", "drive", Map.of("to", "b"), seconds(1), Optional.empty(), second);
    await(() -> first.ended() && second.ended());
    assertThat(second.only().outcome()).isEqualTo(Outcome.TIMED_OUT);
    assertThat(first.only().outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void asksForPrices() {
    join("anna", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    List<List<CostAnswer>> answers = new CopyOnWriteArrayList<>();
    link.cost("anna", "drive", List.of(Map.of("to", "a"), Map.of("to", "b")), answers::add);
    link.cost("anna", "fly", List.of(Map.of()), answers::add);
    link.cost("nobody", "fly", List.of(Map.of()), answers::add);
    await(() -> answers.size() == 3);
    CostAnswer price = new CostAnswer(Optional.of(2.5), Optional.of(2.0), Optional.empty());
    assertThat(answers).contains(List.of(price, price));
    assertThat(answers)
        .filteredOn(list -> list.size() == 1)
        .allSatisfy(list -> assertThat(list.get(0).reason()).isPresent())
        .hasSize(2);
  }

  @Test
  void makesEveryMemberSafe() {
    join("anna", "home");
    join("berta", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna") && usable(link, "berta"));
    Listener first = new Listener();
    Listener second = new Listener();
    link.call("anna", "grip", Map.of(), seconds(600), Optional.empty(), first);
    link.call("berta", "watch", Map.of("object", "x"), seconds(600), Optional.empty(), second);
    await(() -> !second.progress.isEmpty() && !first.progress.isEmpty());
    link.safe();
    await(() -> first.ended() && second.ended());
    assertThat(first.only().outcome()).isEqualTo(Outcome.CANCELED);
    assertThat(second.only().outcome()).isEqualTo(Outcome.CANCELED);
  }

  @Test
  void keepsSitesApart() {
    join("anna", "home");
    TestDevice other = new TestDevice("anna", clock());
    opened.add(
        RatsMember.start(
            other.profile(), () -> List.of(), client("other-anna"), "elsewhere", clock()));
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener listener = new Listener();
    link.call("anna", "echo", Map.of(), seconds(600), Optional.empty(), listener);
    await(listener::ended);
    assertThat(link.members()).extracting(RatsLink.Member::id).containsExactly("anna");
    assertThat(other.log).isEmpty();
  }

  @Test
  void comesThroughAnOutageOfTheBus() {
    join("anna", "home");
    RatsMember berta = join("berta", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna") && usable(link, "berta"));
    Listener watching = new Listener();
    link.call("anna", "watch", Map.of("object", "x"), seconds(600), Optional.empty(), watching);
    await(() -> watching.observations.size() >= 1);
    stopBroker();
    Listener refused = new Listener();
    await(
        () -> {
          if (refused.results.isEmpty()) {
            link.call("anna", "echo", Map.of(), seconds(1), Optional.empty(), refused);
          }
          return refused.ended();
        });
    assertFailed(refused.results.get(0), ErrorCode.BUS_UNAVAILABLE);
    berta.die();
    restartBroker();
    await(() -> member(link, "berta").phase() == MemberStatus.Phase.LOST);
    assertThat(usable(link, "anna")).isTrue();
    int before = watching.observations.size();
    await(() -> watching.observations.size() > before);
    Listener after = new Listener();
    link.call("anna", "echo", Map.of(), seconds(600), Optional.empty(), after);
    await(after::ended);
    assertThat(after.only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(watching.results).isEmpty();
  }

  @Test
  void takesUpTheCallsOfItsFormerLife() {
    TestDevice device = new TestDevice("anna", clock());
    String boot = join(device, "home").boot();
    Transport formerTransport = client("cca");
    RatsLink former = BusLink.connect("cca", "home", formerTransport, clock());
    await(() -> usable(former, "anna"));
    RatsLink.Order drive = order("G1-1", boot, "drive", Map.of("to", "a"));
    RatsLink.Order queued = order("G1-2", boot, "drive", Map.of("to", "b"));
    RatsLink.Order watch = order("G1-3", boot, "watch", Map.of("object", "Cup"));
    RatsLink.Order echo = order("G1-4", boot, "echo", Map.of("a", 1.5, "b", List.of(1.0, 2.0)));
    Map<RatsLink.Order, Listener> before = new LinkedHashMap<>();
    for (RatsLink.Order order : List.of(drive, queued, watch, echo)) {
      before.put(order, new Listener());
      former.call(order, before.get(order));
    }
    await(
        () ->
            before.get(echo).ended()
                && before.get(drive).progress.size() == 2
                && before.get(watch).observations.size() > 0);
    formerTransport.die();
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Map<RatsLink.Order, Listener> after = new LinkedHashMap<>();
    for (RatsLink.Order order : List.of(drive, queued, watch, echo)) {
      after.put(order, new Listener());
      link.call(order, after.get(order));
    }
    await(
        () ->
            after.get(drive).ended()
                && after.get(queued).ended()
                && after.get(echo).ended()
                && after.get(watch).observations.size() > 1);
    assertThat(after.get(drive).only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(after.get(queued).only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(after.get(echo).only()).isEqualTo(before.get(echo).only());
    assertThat(after.get(watch).progress)
        .extracting(Progress::kind)
        .containsExactly(Progress.Kind.ESTABLISHED);
    assertThat(device.log)
        .extracting(line -> line.substring(line.indexOf(' ') + 1))
        .containsOnlyOnce("start watch", "start echo")
        .filteredOn("start drive"::equals)
        .hasSize(2);
  }

  @Test
  void refusesForeignWordsAndLivesForACallOfAFormerLife() {
    TestDevice device = new TestDevice("anna", clock());
    String boot = join(device, "home").boot();
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener first = new Listener();
    link.call(order("G1-1", boot, "echo", Map.of("a", 1)), first);
    await(first::ended);
    Listener other = new Listener();
    link.call(order("G1-1", boot, "echo", Map.of("a", 2)), other);
    Listener late = new Listener();
    link.call(order("G1-2", "a-former-one", "echo", Map.of()), late);
    await(() -> other.ended() && late.ended());
    assertThat(other.only().error().orElseThrow().code()).isEqualTo(ErrorCode.DUPLICATE_ID);
    assertFailed(late.only(), ErrorCode.RESTARTED);
    assertThat(device.log).hasSize(1);
  }

  @Test
  void endsACallOfItsFormerLife() {
    RatsMember anna = join("anna", "home");
    Transport formerTransport = client("cca");
    RatsLink former = BusLink.connect("cca", "home", formerTransport, clock());
    await(() -> usable(former, "anna"));
    Listener watching = new Listener();
    former.call(order("G1-1", anna.boot(), "watch", Map.of("object", "Cup")), watching);
    await(() -> watching.observations.size() > 0);
    formerTransport.die();
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna") && running(link, "anna").contains("G1-1"));
    link.cancel("anna", anna.boot(), "G1-1");
    await(() -> running(link, "anna").isEmpty());
  }

  @Test
  void endsEveryCallWhenItCloses() {
    join("anna", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener listener = new Listener();
    link.call("anna", "watch", Map.of("object", "x"), seconds(600), Optional.empty(), listener);
    await(() -> listener.observations.size() >= 1);
    link.close();
    await(listener::ended);
    assertFailed(listener.only(), ErrorCode.BUS_UNAVAILABLE);
    link.close();
  }

  @Test
  void refusesParametersThatJsonCannotHold() {
    RatsLink link = connect("cca", "home");
    assertThatThrownBy(
            () ->
                link.call(
                    "anna",
                    "echo",
                    Map.of("a", Double.NaN),
                    seconds(1),
                    Optional.empty(),
                    new Listener()))
        .isInstanceOf(IllegalArgumentException.class);
  }

  private static RatsLink.Order order(
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

  private static List<String> running(RatsLink link, String id) {
    return member(link, id).state().orElseThrow().running();
  }

  private RatsMember join(String id, String site) {
    return join(new TestDevice(id, clock()), site);
  }

  private RatsMember join(TestDevice device, String site) {
    String id = device.profile().id();
    RatsMember member =
        RatsMember.start(
            device.profile(), () -> List.copyOf(device.facts), client(id), site, clock());
    opened.add(member);
    return member;
  }

  private RatsLink connect(String id, String site) {
    RatsLink link = BusLink.connect(id, site, client(id), clock());
    opened.add(0, link);
    return link;
  }

  private static boolean usable(RatsLink link, String id) {
    return link.members().stream()
        .anyMatch(
            member ->
                member.id().equals(id)
                    && member.phase() == MemberStatus.Phase.READY
                    && member.description().isPresent()
                    && member.state().isPresent());
  }

  private static RatsLink.Member member(RatsLink link, String id) {
    return link.members().stream()
        .filter(member -> member.id().equals(id))
        .findFirst()
        .orElseThrow();
  }

  private static Duration seconds(int seconds) {
    return Duration.ofSeconds(seconds);
  }

  private static void assertFailed(Result result, ErrorCode code) {
    assertThat(result.outcome()).isEqualTo(Outcome.FAILED);
    assertThat(result.error().orElseThrow().code()).isEqualTo(code);
  }

  private static final class Listener implements RatsLink.CallListener {
    private final List<Progress> progress = new CopyOnWriteArrayList<>();
    private final List<Observation> observations = new CopyOnWriteArrayList<>();
    private final List<Result> results = new CopyOnWriteArrayList<>();

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
