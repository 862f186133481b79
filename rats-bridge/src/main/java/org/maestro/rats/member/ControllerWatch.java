package org.maestro.rats.member;

import java.util.HashMap;
import java.util.Map;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Notices that a controller is gone. What runs for it goes on by the local plan; some time later
 * what it keeps going ends, and the member rests in a safe state. Clock thread only.
 */
final class ControllerWatch {

  private static final Logger LOG = LoggerFactory.getLogger(ControllerWatch.class);

  private final String member;
  private final Topics topics;
  private final StateRules rules;
  private final TaskQueue tasks;
  private final Clock clock;
  private final WireFormat wire = new WireFormat();
  private final Map<String, String> presentBoots = new HashMap<>();
  private final Map<String, Clock.Timer> rests = new HashMap<>();

  ControllerWatch(String member, Topics topics, StateRules rules, TaskQueue tasks, Clock clock) {
    this.member = member;
    this.topics = topics;
    this.rules = rules;
    this.tasks = tasks;
    this.clock = clock;
  }

  void heard(Message message) {
    topics
        .controllerOf(message.topic())
        .ifPresent(
            controller -> {
              try {
                heard(controller, message);
              } catch (MalformedMessageException malformed) {
                LOG.debug("{} heard a malformed status: {}", member, malformed.getMessage());
              }
            });
  }

  private void heard(String controller, Message message) {
    if (message.payload().length == 0) {
      gone(controller);
      return;
    }
    MemberStatus status = wire.decodeStatus(message.payload());
    boolean leaves =
        status.phase() == MemberStatus.Phase.LOST
            || status.phase() == MemberStatus.Phase.DISCONNECTED;
    if (!leaves) {
      presentBoots.put(controller, status.boot());
      Clock.Timer rest = rests.remove(controller);
      if (rest != null) {
        rest.cancel();
      }
    } else if (status.boot().equals(presentBoots.get(controller))) {
      gone(controller);
    }
  }

  private void gone(String controller) {
    if (presentBoots.remove(controller) != null) {
      rests.put(
          controller,
          clock.schedule(
              rules.restAfterLoss(),
              member,
              () -> {
                rests.remove(controller);
                tasks.abandonedBy(controller);
              }));
    }
  }
}
