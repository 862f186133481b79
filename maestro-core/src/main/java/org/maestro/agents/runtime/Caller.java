package org.maestro.agents.runtime;

import jade.lang.acl.ACLMessage;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.agents.content.AgentNames;
import org.maestro.coordination.api.Requester;

/**
 * The agent that asks another for something, and its user.
 *
 * @param agent its local name
 * @param user in whose process it lives, where the site is secured and that was proven
 */
public record Caller(String agent, Optional<String> user) {
  /**
   * The slot of a message in which its receiver reads the user. Whoever delivers a message on a
   * secured site has proven it; nobody else may fill it.
   */
  public static final String USER_SLOT = "X-maestro-user";

  private static final char AT = '@';

  public static Caller of(ACLMessage message) {
    return new Caller(
        message.getSender().getLocalName(),
        Optional.ofNullable(message.getUserDefinedParameter(USER_SLOT)));
  }

  /**
   * The same, where agents of other platforms are heard: one of those is called by its platform and
   * its name, so that nobody takes it for an agent of ours.
   */
  public static Caller of(ACLMessage message, String ownPlatform) {
    String name = message.getSender().getName();
    int at = name.lastIndexOf(AT);
    return at < 0 || name.substring(at + 1).equals(ownPlatform)
        ? of(message)
        : new Caller(name.substring(at + 1) + "/" + name.substring(0, at), Optional.empty());
  }

  /**
   * The same where the desk asks for a person who has signed in there; nobody else is believed to
   * ask for another.
   *
   * @param person for whom it says that it asks
   */
  public Caller askingFor(Optional<String> person) {
    return agent.equals(AgentNames.DESK) && person.isPresent() ? new Caller(agent, person) : this;
  }

  /** What {@link #toString} wrote, and of what a goal says of who asks for it the same. */
  public static Caller parse(String requester) {
    String text = Requester.parse(requester).caller();
    int at = text.lastIndexOf(AT);
    return at < 0
        ? new Caller(text, Optional.empty())
        : new Caller(text.substring(0, at), Optional.of(text.substring(at + 1)));
  }

  /** All by which permissions may name it. */
  public Set<String> names() {
    Set<String> names = new TreeSet<>(Set.of(agent));
    user.ifPresent(names::add);
    return names;
  }

  @Override
  public String toString() {
    return user.map(name -> agent + AT + name).orElse(agent);
  }
}
