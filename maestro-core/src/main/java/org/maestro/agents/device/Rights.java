package org.maestro.agents.device;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Caller;
import org.maestro.ontology.home.AccessList;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Permission;
import org.maestro.sl.Content;

/**
 * The access rights at a generic agent, as the knowledge agent told them (who may ask for what):
 * {@code (:permissions (:permission (:caller "tablet") (:permits "dim")) ...)}.
 *
 * @param known false until it was told
 * @param permissions that speak of the agent's device; empty: no list is stated, all is allowed
 */
public record Rights(boolean known, Optional<List<Permission>> permissions) {
  /** On a secured site an agent does nothing before it knows for whom. */
  static final Rights UNKNOWN = new Rights(false, Optional.empty());

  /** What the knowledge agent adds to its answer; nothing where everything is allowed. */
  public static List<Content.Argument> words(AccessList access, Device device) {
    if (access.isOpen()) {
      return List.of();
    }
    List<Content.Argument> told = new ArrayList<>();
    for (Permission permission : access.about(device)) {
      told.add(
          Words.named(
              "permission",
              Words.named("caller", permission.callers().stream().map(Words::text).toList()),
              Words.named("permits", permission.permits().stream().map(Words::text).toList())));
    }
    return List.of(Words.named("permissions", told));
  }

  static Rights read(Words words) {
    return new Rights(
        true,
        words
            .find("permissions")
            .map(
                told ->
                    told.all().stream()
                        .map(Words::of)
                        .map(
                            one ->
                                new Permission(
                                    texts(one, "caller"),
                                    Set.of(),
                                    texts(one, "permits"),
                                    Set.of(),
                                    Set.of()))
                        .toList()));
  }

  private static Set<String> texts(Words words, String name) {
    Set<String> texts = new HashSet<>();
    words.find(name).ifPresent(told -> told.terms().forEach(term -> texts.add(Words.plain(term))));
    return texts;
  }

  /**
   * Why the agent does not do this for who asks. The central agent asks for others, and has to say
   * for whom; for itself it may ask everything. The desk may ask for a person.
   *
   * @param words of what is asked
   * @return empty when it does
   */
  Optional<String> objection(ACLMessage message, Words words, String device, String feature) {
    Caller sender = Caller.of(message);
    if (!known) {
      return sender
          .user()
          .map(user -> device + " does not know yet who may ask it; ask again in a moment");
    }
    if (permissions.isEmpty()) {
      return Optional.empty();
    }
    boolean isCentre = sender.agent().equals(AgentNames.COORDINATOR);
    Optional<String> client = words.string("for");
    if (isCentre && client.isEmpty()) {
      return Optional.empty();
    }
    Caller caller = isCentre ? Caller.parse(client.get()) : sender.askingFor(client);
    return AccessList.objection(permissions.get(), caller.names(), device, feature);
  }
}
