package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.agents.content.GoalReport;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.Latest;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;

/**
 * The ends of goals, for those who stated them and for whoever asks, before or afterwards. Agent
 * thread only.
 */
final class Endings {

  /** Sends a reply. */
  interface Voice {
    void reply(ACLMessage to, int performative, Content content);
  }

  private record Ending(boolean reached, Content content, long bytes) {}

  private static final long MOST_BYTES = 512 << 10;
  private static final long BYTES_OF_A_CONTENT = 1_536;

  private final Voice voice;
  private final Latest<Ending> endings = new Latest<>(MOST_BYTES, Ending::bytes);
  private final Map<String, List<ACLMessage>> waiting = new HashMap<>();

  Endings(Voice voice) {
    this.voice = voice;
  }

  /** Replies to the message at the goal's end, at once when it has come. */
  void await(String goalId, ACLMessage message) {
    Optional<Ending> ending = endings.find(goalId);
    if (ending.isPresent()) {
      tell(message, ending.get());
    } else {
      waiting.computeIfAbsent(goalId, id -> new ArrayList<>()).add(message);
    }
  }

  boolean isOver(String goalId) {
    return endings.find(goalId).isPresent();
  }

  /**
   * The goal has ended.
   *
   * @param goal as it was stated
   */
  void ended(Formula goal, GoalOutcome outcome) {
    Ending ending =
        new Ending(
            outcome.reached(),
            GoalReport.words(goal, outcome),
            BYTES_OF_A_CONTENT + outcome.bytes());
    endings.put(outcome.id(), ending);
    Optional.ofNullable(waiting.remove(outcome.id()))
        .ifPresent(messages -> messages.forEach(message -> tell(message, ending)));
  }

  private void tell(ACLMessage message, Ending ending) {
    voice.reply(
        message, ending.reached() ? ACLMessage.INFORM : ACLMessage.FAILURE, ending.content());
  }
}
