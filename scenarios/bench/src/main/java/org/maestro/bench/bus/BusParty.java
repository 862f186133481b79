package org.maestro.bench.bus;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.net.URI;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Transport;

/** A caller and members that answer at once: by the bus, or by the bare client. */
interface BusParty extends AutoCloseable {

  /** Calls a member; the action runs when its answer is there. */
  void call(int member, Runnable answered);

  @Override
  void close();

  /** Members of the runtime, called through the link. */
  static BusParty ofMembers(URI broker, int members, byte[] padding, Clock clock) {
    List<RatsMember> joined = new ArrayList<>();
    for (int number = 0; number < members; number++) {
      String id = "member-" + number;
      joined.add(start(id, new PahoTransport(broker, id), clock));
    }
    RatsLink link = BusLink.connect("bench", "bench", new PahoTransport(broker, "bench"), clock);
    Map<String, Object> parameters = Map.of("padding", new String(padding, US_ASCII));
    awaitReady(link, members);
    return new BusParty() {
      @Override
      public void call(int member, Runnable answered) {
        link.call(
            "member-" + member,
            "echo",
            parameters,
            Duration.ofSeconds(30),
            Optional.empty(),
            new RatsLink.CallListener() {
              @Override
              public void ended(Result result) {
                if (result.outcome() != Outcome.SUCCEEDED) {
                  throw new IllegalStateException("A call failed: " + result);
                }
                answered.run();
              }
            });
      }

      @Override
      public void close() {
        joined.forEach(RatsMember::close);
        link.close();
      }
    };
  }

  private static void awaitReady(RatsLink link, int members) {
    Semaphore ready = new Semaphore(0);
    Set<String> told = new HashSet<>();
    link.watch(
        member -> {
          if (member.phase() == MemberStatus.Phase.READY
              && member.state().isPresent()
              && told.add(member.id())) {
            ready.release();
          }
        });
    try {
      if (!ready.tryAcquire(members, 60, TimeUnit.SECONDS)) {
        throw new IllegalStateException("Not all members came within a minute");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("The benchmark was interrupted", e);
    }
  }

  /** A member that answers {@code echo} with what it was called with. */
  static RatsMember start(String id, Transport transport, Clock clock) {
    Procedure echo =
        new Procedure() {
          @Override
          public void start(Execution execution) {
            execution.succeed(execution.call().parameters());
          }

          @Override
          public CostAnswer cost(Map<String, Object> parameters) {
            return new CostAnswer(Optional.of(1.0), Optional.of(1.0), Optional.empty());
          }
        };
    MemberProfile profile =
        new MemberProfile(
            id,
            "{}",
            Set.of("standby"),
            "standby",
            Set.of("standby"),
            MemberProfile.byId(
                List.of(
                    new MemberProfile.Feature(
                        "echo", Set.of(), Set.of(), false, Optional.empty(), "standby", echo))));
    return RatsMember.start(profile, List::of, transport, "bench", clock);
  }

  /** Bare clients that all hear every call, and answer their own with the same bytes. */
  static BusParty ofBareClients(URI broker, int members, byte[] payload) {
    List<BarePaho> joined = new ArrayList<>();
    for (int number = 0; number < members; number++) {
      byte own = (byte) number;
      List<BarePaho> self = new ArrayList<>();
      self.add(
          new BarePaho(
              broker,
              "bare-" + number,
              "bare/call/#",
              (topic, bytes) -> {
                if (bytes[0] == own) {
                  self.get(0).publish("bare/result/bench", bytes);
                }
              }));
      joined.addAll(self);
    }
    Map<Integer, Runnable> waiting = new ConcurrentHashMap<>();
    BarePaho caller =
        new BarePaho(
            broker,
            "bare-caller",
            "bare/result/bench",
            (topic, bytes) -> waiting.remove(number(bytes)).run());
    AtomicInteger count = new AtomicInteger();
    return new BusParty() {
      @Override
      public void call(int member, Runnable answered) {
        int number = count.incrementAndGet();
        byte[] bytes = payload.clone();
        bytes[0] = (byte) member;
        for (int shift = 0; shift < 4; shift++) {
          bytes[1 + shift] = (byte) (number >>> (8 * shift));
        }
        waiting.put(number, answered);
        caller.publish("bare/call/bench", bytes);
      }

      @Override
      public void close() {
        joined.forEach(BarePaho::close);
        caller.close();
      }
    };
  }

  private static int number(byte[] bytes) {
    int number = 0;
    for (int shift = 0; shift < 4; shift++) {
      number |= (bytes[1 + shift] & 0xff) << (8 * shift);
    }
    return number;
  }
}
