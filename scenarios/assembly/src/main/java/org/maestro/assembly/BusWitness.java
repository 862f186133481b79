package org.maestro.assembly;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Transport;

/**
 * Listens to a site's bus and counts what members do: by their own states, which name the calls
 * that run. Told on the transport's thread; any thread may ask.
 */
public final class BusWitness implements AutoCloseable {
  private final Transport transport;
  private final Topics topics;
  private final WireFormat wire = new WireFormat();
  private final Map<String, Call> calls = new LinkedHashMap<>();
  private final Map<String, Integer> heard = new TreeMap<>();
  private final Map<String, Integer> executions = new LinkedHashMap<>();
  private final Map<String, Set<String>> runningByMember = new TreeMap<>();
  private final Set<String> succeeded = new LinkedHashSet<>();

  private BusWitness(Transport transport, String site) {
    this.transport = transport;
    this.topics = new Topics(site);
  }

  /**
   * @param transport not open yet; closed with the witness
   */
  public static BusWitness listen(Transport transport, String site) {
    BusWitness witness = new BusWitness(transport, site);
    witness.open();
    return witness;
  }

  private void open() {
    transport.subscribe(
        topics.calls(),
        Transport.RetainedMessages.IGNORE,
        message -> called(wire.decodeCall(message.payload())));
    transport.subscribe(
        topics.states(),
        Transport.RetainedMessages.SEND,
        message -> {
          if (message.payload().length > 0) {
            told(wire.decodeState(message.payload()));
          }
        });
    transport.subscribe(
        topics.results("+"),
        Transport.RetainedMessages.IGNORE,
        message -> ended(wire.decodeResult(message.payload())));
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            // It only listens.
          }

          @Override
          public void lost(String reason) {
            // It only listens.
          }
        });
  }

  private synchronized void called(Call call) {
    if (!call.feature().startsWith("$")) {
      calls.putIfAbsent(call.id(), call);
      heard.merge(call.id(), 1, Integer::sum);
    }
  }

  private synchronized void told(MemberState state) {
    Set<String> running = new LinkedHashSet<>(state.running());
    Set<String> before = runningByMember.getOrDefault(state.member(), Set.of());
    running.stream()
        .filter(id -> !before.contains(id))
        .forEach(id -> executions.merge(id, 1, Integer::sum));
    runningByMember.put(state.member(), running);
  }

  private synchronized void ended(Result result) {
    if (result.outcome() == Outcome.SUCCEEDED) {
      succeeded.add(result.id());
    }
  }

  /** Calls that ran more than once. */
  public synchronized List<String> executedTwice() {
    return executions.entrySet().stream()
        .filter(entry -> entry.getValue() > 1)
        .map(entry -> entry.getKey() + " " + entry.getValue() + " times")
        .toList();
  }

  /**
   * Deeds that succeeded more than once for the same goal. Two calls are the same deed when they
   * mean the same: the same feature of the same member, on the same things. Ids, poses and what
   * else is told of those things may differ.
   *
   * @throws IllegalStateException when a feature was never called, of which the answer would say
   *     nothing
   */
  public synchronized List<String> doneTwice(Set<String> features) {
    Set<String> called =
        calls.values().stream().map(Call::feature).collect(Collectors.toCollection(TreeSet::new));
    if (!called.containsAll(features)) {
      throw new IllegalStateException(
          "Not all of %s were called, only %s.".formatted(new TreeSet<>(features), called));
    }
    Map<String, Integer> deeds = new TreeMap<>();
    for (String id : succeeded) {
      Call call = calls.get(id);
      if (call != null && features.contains(call.feature())) {
        String deed =
            call.task().orElse("-")
                + " "
                + call.member().orElse("-")
                + " "
                + call.feature()
                + " "
                + meant(call.parameters());
        deeds.merge(deed, 1, Integer::sum);
      }
    }
    return deeds.entrySet().stream()
        .filter(entry -> entry.getValue() > 1)
        .map(Map.Entry::getKey)
        .toList();
  }

  private static Map<String, Object> meant(Map<String, Object> parameters) {
    Map<String, Object> meant = new TreeMap<>();
    parameters.forEach(
        (name, value) -> {
          if (value instanceof Map<?, ?> pointer) {
            meant.put(name, String.valueOf(pointer.get("ref")));
          } else if (!(value instanceof List<?>)) {
            meant.put(name, value);
          }
        });
    return meant;
  }

  /** Calls that were sent again. */
  public synchronized List<String> heardAgain() {
    return heard.entrySet().stream()
        .filter(entry -> entry.getValue() > 1)
        .map(Map.Entry::getKey)
        .toList();
  }

  /** The goals that calls run for now. */
  public synchronized Set<String> goalsWithSomethingRunning() {
    Set<String> goals = new LinkedHashSet<>();
    for (Set<String> running : runningByMember.values()) {
      for (String id : running) {
        Optional.ofNullable(calls.get(id)).flatMap(Call::task).ifPresent(goals::add);
      }
    }
    return goals;
  }

  public synchronized int executed() {
    return executions.size();
  }

  @Override
  public void close() {
    transport.close();
  }
}
