package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;

/** Link and members from end to end; run over each transport with its clock. */
abstract class LinkContract extends FormerLivesContract {

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
  void whoHasOneOfManyMembersHearsOfNoOther() {
    join("anna", "home");
    RatsLink link = connectForWatched("cca", "home");
    List<String> told = new CopyOnWriteArrayList<>();
    link.watch(member -> told.add(member.id()));
    link.watch("berta", member -> {});
    RatsMember berta = join("berta", "home");
    await(() -> usable(link, "berta"));
    Listener answered = new Listener();
    Listener watching = new Listener();
    link.call("berta", "echo", Map.of("a", 1), seconds(600), Optional.empty(), answered);
    link.call("berta", "watch", Map.of("object", "Cup"), seconds(600), Optional.empty(), watching);
    await(() -> answered.ended() && !watching.observations.isEmpty());
    berta.die();
    await(watching::ended);
    assertFailed(watching.only(), ErrorCode.MEMBER_LOST);
    link.watch("anna", member -> {});
    await(() -> usable(link, "anna"));

    assertThat(told.subList(0, told.indexOf("anna"))).containsOnly("berta");
    assertThat(link.members()).extracting(RatsLink.Member::id).containsExactly("berta", "anna");
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
  void whoIsAskedToDescribeItselfHasToldItsStateOrIsNotWaitedForLong() {
    join("anna", "home");
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    long before = member(link, "anna").statesHeard();
    List<Long> heardThen = new CopyOnWriteArrayList<>();
    link.describe(
        "anna", seconds(5), () -> heardThen.add(member(link, "anna").statesHeard() - before));
    await(() -> member(link, "anna").statesHeard() > before && !heardThen.isEmpty());
    assertThat(heardThen).hasSize(1);

    List<String> over = new CopyOnWriteArrayList<>();
    link.describe("nobody", seconds(1), () -> over.add("nobody"));
    await(() -> over.equals(List.of("nobody")));
  }

  @Test
  void makesEveryMemberSafe() {
    join(new TestDevice("anna", clock()).gripping(300), "home");
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
    for (String id : List.of("anna", "berta")) {
      await(() -> member(link, id).state().orElseThrow().state().equals("standby"));
    }
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
    assertThat(link.absence()).isEmpty();
    stopBroker();
    await(() -> link.absence().isPresent());
    Listener refused = new Listener();
    await(
        () -> {
          if (refused.results.isEmpty()) {
            link.call("anna", "echo", Map.of(), seconds(1), Optional.empty(), refused);
          }
          return refused.ended();
        });
    // A broker that is slow to end tells some the wills of those whom it cut off before.
    boolean willWasTold = !watching.results.isEmpty();
    assertFailed(
        refused.results.get(0), willWasTold ? ErrorCode.MEMBER_LOST : ErrorCode.BUS_UNAVAILABLE);
    berta.die();
    restartBroker();
    // Who was told berta's will by the broker that ended may not be back yet.
    await(() -> member(link, "berta").phase() == MemberStatus.Phase.LOST);
    await(() -> link.absence().isEmpty());
    await(() -> usable(link, "anna"));
    int before = watching.observations.size();
    await(() -> willWasTold || watching.observations.size() > before);
    Listener after = new Listener();
    link.call("anna", "echo", Map.of(), seconds(600), Optional.empty(), after);
    await(after::ended);
    assertThat(after.only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(watching.results).hasSize(willWasTold ? 1 : 0);
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
}
