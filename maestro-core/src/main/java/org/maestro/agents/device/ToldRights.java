package org.maestro.agents.device;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.ontology.home.AccessList;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.LatestAccess;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The rights that agents of devices were told when they introduced these, and are told again as
 * soon as the home has others: {@code (permit (:member rose) (:permissions ...))}. An agent goes by
 * the new ones from its next call on, and confirms that (ADE, 3.1; A28). Agent thread only.
 */
public final class ToldRights {
  private static final Logger LOG = LoggerFactory.getLogger(ToldRights.class);
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);

  /** What an agent is told. */
  public static final String OPERATOR = "permit";

  private final MaestroAgent agent;
  private final Supplier<Home> home;
  private final Map<String, Told> toldByMember = new TreeMap<>();
  private final LatestAccess access = new LatestAccess();
  private int unconfirmed;

  private record Told(AID agent, List<Content.Argument> rights) {}

  /**
   * @param agent that tells them
   * @param home as it is known at the time
   */
  public ToldRights(MaestroAgent agent, Supplier<Home> home) {
    this.agent = agent;
    this.home = home;
  }

  /** What an agent is told that introduces a device. */
  public List<Content.Argument> introduced(Device device, AID its) {
    List<Content.Argument> rights = Rights.words(list(), device);
    toldByMember.put(device.id(), new Told(its, rights));
    return rights;
  }

  /** The home may have other permissions than before. */
  public void changed() {
    List<String> members = new ArrayList<>();
    toldByMember.forEach(
        (member, told) -> {
          Optional<Device> device = Optional.ofNullable(home.get().devices().get(member));
          if (device.filter(its -> !Rights.words(list(), its).equals(told.rights())).isPresent()) {
            members.add(member);
          }
        });
    members.forEach(this::tell);
  }

  private void tell(String member) {
    Told before = toldByMember.get(member);
    Device device = home.get().devices().get(member);
    if (before == null || device == null) {
      return;
    }
    Told now = new Told(before.agent(), Rights.words(list(), device));
    toldByMember.put(member, now);
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("member", Words.name(member)));
    arguments.addAll(now.rights());
    unconfirmed++;
    agent.ask(
        agent.message(ACLMessage.REQUEST, now.agent(), new Content(OPERATOR, arguments)),
        ANSWER_WITHIN,
        reply -> {
          if (Conversations.isFinal(reply)) {
            answered(member, now, reply);
          }
        });
  }

  private void answered(String member, Told told, ACLMessage reply) {
    unconfirmed--;
    boolean isCurrent = told.equals(toldByMember.get(member));
    if (isCurrent && Conversations.isOverdue(reply)) {
      LOG.warn("{} has not confirmed that its callers may ask for something else now", member);
      tell(member);
    } else if (isCurrent && Replies.isFromPlatform(reply)) {
      // The next one is told them when it introduces the device.
      toldByMember.remove(member);
    }
    if (unconfirmed == 0) {
      LOG.info("All agents go by the permissions that the home has now");
    }
  }

  private AccessList list() {
    return access.of(home.get());
  }
}
