package org.maestro.chaos;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;

/**
 * The calls and states heard on a bus, and violations found in them: a call that ran twice, one
 * that nobody made, one that began after its time. What members execute is read from their states.
 * For the thread that lets time pass.
 */
final class BusHistory {
  private static final String CONTROLLER = "maestro";

  /** A state may tell so much later of what has begun. */
  private static final Duration TOLD_LATE = Duration.ofSeconds(10);

  private final WireFormat wire = new WireFormat();
  private final Map<String, Made> calls = new LinkedHashMap<>();
  private final Map<String, Set<String>> runningByLife = new TreeMap<>();
  private final Set<String> begun = new LinkedHashSet<>();
  private final List<String> findings = new ArrayList<>();

  private record Made(Call call, Duration at) {}

  void listen(InProcessBus bus, Clock clock) {
    Transport witness = bus.client("witness");
    witness.subscribe(
        "rats/1/+/call/#",
        Transport.RetainedMessages.IGNORE,
        message -> read(message, bytes -> called(wire.decodeCall(bytes), clock.now())));
    witness.subscribe(
        "rats/1/+/member/+/state",
        Transport.RetainedMessages.SEND,
        message -> read(message, bytes -> told(wire.decodeState(bytes), clock.now())));
    witness.open(Optional.empty(), new Stranger.Unconcerned());
  }

  private static void read(Message message, Consumer<byte[]> reader) {
    try {
      if (message.payload().length > 0) {
        reader.accept(message.payload());
      }
    } catch (MalformedMessageException rubbish) {
      // Nobody is to act on it, and that is seen from what follows.
      assert rubbish.getMessage() != null;
    }
  }

  private void called(Call call, Duration now) {
    if (call.from().equals(CONTROLLER) && !call.feature().startsWith("$")) {
      calls.putIfAbsent(call.id(), new Made(call, now));
    }
  }

  private void told(MemberState state, Duration now) {
    String life = state.member() + " " + state.boot();
    Set<String> running = new LinkedHashSet<>(state.running());
    Set<String> before = runningByLife.getOrDefault(life, Set.of());
    running.stream().filter(id -> !before.contains(id)).forEach(id -> began(id, state, now));
    runningByLife.put(life, running);
  }

  private void began(String id, MemberState state, Duration now) {
    Made made = calls.get(id);
    if (!begun.add(id)) {
      findings.add(
          "TWICE %s runs %s for the second time, at %s".formatted(state.member(), id, now));
    } else if (made == null) {
      findings.add("NO_CONTRACT %s runs %s, which nobody called".formatted(state.member(), id));
    } else if (made.call.member().filter(state.member()::equals).isEmpty()) {
      findings.add("WRONG_DOER %s runs %s of another".formatted(state.member(), id));
    } else if (now.compareTo(made.at.plus(made.call.timeout()).plus(TOLD_LATE)) > 0) {
      findings.add(
          "TOO_LATE %s begins %s at %s; it was called at %s for %s"
              .formatted(state.member(), id, now, made.at, made.call.timeout()));
    }
  }

  List<String> findings() {
    return List.copyOf(findings);
  }
}
