package org.maestro.rats.link;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** What others say of a member's life: on an open site anybody may say anything. */
abstract class HearsayContract extends LinkParty {
  private static final String HOME = "hearsay";

  /** Wall time. */
  private static final Duration NOTICED_WITHIN = Duration.ofSeconds(6);

  /** How many random runs there are. */
  abstract int seeds();

  @Test
  void aForgedEndFailsNoCallThatRuns() {
    TestDevice device = new TestDevice("anna", clock());
    RatsMember anna = join(device, HOME);
    RatsLink link = connect("cca", HOME);
    Forger forger = new Forger(HOME);
    await(() -> usable(link, "anna"));
    for (String forged : forgeries(anna)) {
      List<Listener> calls = List.of(drive(link), drive(link));
      await(() -> started(calls.get(0)));
      forger.say(forged);
      await(() -> calls.stream().allMatch(Listener::ended));
      assertThat(calls)
          .as(forged)
          .allSatisfy(call -> assertThat(call.only().outcome()).isEqualTo(Outcome.SUCCEEDED));
      await(() -> isReady(link, anna));
    }
    assertThat(device.log)
        .as("nothing was done twice")
        .filteredOn(line -> line.endsWith("start drive"))
        .hasSize(2 * forgeries(anna).size());
  }

  @Test
  void aForgedEndEndsNobodyForGood() {
    RatsMember anna = join("anna", HOME);
    RatsLink link = connect("cca", HOME);
    Forger forger = new Forger(HOME);
    await(() -> usable(link, "anna"));
    for (String forged : forgeries(anna)) {
      endsNotForGood(link, "anna", anna.boot(), () -> forger.say(forged));
    }
  }

  /** It is back, after it was believed to be gone. */
  final void endsNotForGood(RatsLink link, String id, String boot, Runnable forgery) {
    List<RatsLink.Member> told = new CopyOnWriteArrayList<>();
    Runnable watch = link.watch(id, told::add);
    forgery.run();
    await(() -> told.stream().anyMatch(member -> !isReady(member, boot)));
    await(() -> usable(link, id) && isReady(member(link, id), boot));
    watch.run();
  }

  /** Members end what runs for a controller a minute after it is gone. */
  @Test
  void aForgedEndOfAControllerEndsNothing() {
    join("anna", HOME);
    RatsLink link = connect("cca", HOME);
    await(() -> usable(link, "anna"));
    Listener watching = new Listener();
    link.call("anna", "watch", Map.of("object", "Cup"), seconds(600), Optional.empty(), watching);
    await(() -> !watching.observations.isEmpty());
    Forger forger = new Forger(HOME, new Topics(HOME).controllerStatus("cca"));
    forger.say("");
    await(() -> watching.observations.size() > 70 || watching.ended());
    assertThat(watching.results).isEmpty();
  }

  @Test
  void whoIsReallyStartedAgainHasLostItsCall() {
    RatsMember anna = join("anna", HOME);
    RatsLink link = connect("cca", HOME);
    await(() -> usable(link, "anna"));
    Listener watching = new Listener();
    link.call("anna", "watch", Map.of("object", "Cup"), seconds(600), Optional.empty(), watching);
    await(() -> !watching.observations.isEmpty());
    anna.die();
    RatsMember again = join("anna", HOME);
    await(watching::ended);
    assertFailed(watching.only(), ErrorCode.MEMBER_LOST);
    assertThat(watching.only().error().orElseThrow().message()).startsWith("anna was lost: ");
    await(() -> isReady(link, again));
  }

  /** Lies at random moments, and deaths at some: calls fail by deaths alone, and soon. */
  @Test
  void liesAtRandomMomentsFailNothingAndDeathsDo() {
    lies(0, seeds());
  }

  @Test
  @Tag("full")
  void soManyMoreOfThem() {
    lies(seeds(), 20 * seeds());
  }

  private void lies(int first, int end) {
    for (int seed = first; seed < end; seed++) {
      Random chance = new Random(seed);
      String site = HOME + seed;
      if (chance.nextInt(3) == 0) {
        deathAmongLies(chance, site);
      } else {
        onlyLies(chance, site);
      }
    }
  }

  private void onlyLies(Random chance, String site) {
    RatsMember anna = join("anna", site);
    RatsLink link = connect("cca", site);
    await(() -> usable(link, "anna"));
    List<Listener> calls = List.of(drive(link), drive(link), drive(link));
    lie(chance, site, anna);
    await(() -> calls.stream().allMatch(Listener::ended));
    assertThat(calls)
        .as(site)
        .allSatisfy(call -> assertThat(call.only().outcome()).isEqualTo(Outcome.SUCCEEDED));
    await(() -> isReady(link, anna));
    link.close();
    anna.close();
  }

  private void deathAmongLies(Random chance, String site) {
    RatsMember anna = join("anna", site);
    RatsLink link = connect("cca", site);
    await(() -> usable(link, "anna"));
    Listener watching = new Listener();
    link.call("anna", "watch", Map.of("object", "Cup"), seconds(600), Optional.empty(), watching);
    lie(chance, site, anna);
    AtomicReference<Duration> death = new AtomicReference<>();
    clock()
        .schedule(
            upTo(chance, 5),
            "death",
            () -> {
              death.set(clock().now());
              anna.die();
            });
    await(watching::ended);
    assertThat(death.get()).as("%s: it died before it was said to have", site).isNotNull();
    double wallSeconds = clock().now().minus(death.get()).toMillis() / clock().speed() / 1_000;
    assertThat(wallSeconds).as(site).isLessThan(NOTICED_WITHIN.toSeconds());
    assertFailed(watching.only(), ErrorCode.MEMBER_LOST);
    link.close();
  }

  private void lie(Random chance, String site, RatsMember anna) {
    Forger forger = new Forger(site);
    List<String> forgeries = forgeries(anna);
    for (int lies = chance.nextInt(6); lies >= 0; lies--) {
      String forged = forgeries.get(chance.nextInt(forgeries.size()));
      clock().schedule(upTo(chance, 6), "forger", () -> forger.say(forged));
    }
  }

  private static Duration upTo(Random chance, int seconds) {
    return Duration.ofMillis(chance.nextInt(seconds * 1_000));
  }

  private static Listener drive(RatsLink link) {
    Listener call = new Listener();
    link.call("anna", "drive", Map.of("to", "a"), seconds(600), Optional.empty(), call);
    return call;
  }

  private static boolean started(Listener call) {
    return call.progress.stream().anyMatch(sign -> sign.kind() == Progress.Kind.STARTED);
  }

  private static boolean isReady(RatsLink link, RatsMember member) {
    return link.members().stream().anyMatch(known -> isReady(known, member.boot()));
  }

  private static boolean isReady(RatsLink.Member member, String boot) {
    return member.phase() == MemberStatus.Phase.READY && member.boot().equals(boot);
  }

  private static List<String> forgeries(RatsMember anna) {
    return forgeries("anna", anna.boot());
  }

  /** Ends of the present life, other lives before and after every real one, and no status. */
  static List<String> forgeries(String id, String present) {
    List<String> all = new ArrayList<>();
    all.add("");
    for (MemberStatus.Phase phase : MemberStatus.Phase.values()) {
      for (String boot : List.of(present, "0", "zzzzzzzzzzzzzz")) {
        boolean isTrue = boot.equals(present) && phase == MemberStatus.Phase.READY;
        boolean isOver = !boot.equals(present) && phase.compareTo(MemberStatus.Phase.READY) > 0;
        if (!isTrue && !isOver) {
          all.add(new String(new WireFormat().encode(new MemberStatus(id, phase, boot)), UTF_8));
        }
      }
    }
    return all;
  }

  /** Says of a life what it likes. */
  final class Forger {
    private final String topic;
    private final Transport transport;

    Forger(String site) {
      this(site, new Topics(site).status("anna"));
    }

    Forger(String site, String topic) {
      this.topic = topic;
      transport = client("forger-" + site);
      opened.add(transport::close);
      AtomicBoolean there = new AtomicBoolean();
      transport.open(
          Optional.empty(),
          new Transport.ConnectionListener() {
            @Override
            public void connected() {
              there.set(true);
            }

            @Override
            public void lost(String reason) {
              // It is there again after the next connect.
            }
          });
      await(there::get);
    }

    void say(String status) {
      transport.publish(
          Publication.retained(topic, status.getBytes(UTF_8)),
          failure -> assertThat(failure).isEmpty());
    }
  }
}
