package org.maestro.agents.supervision;

import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.FIPAManagementVocabulary;
import jade.domain.FIPAAgentManagement.SearchConstraints;
import jade.domain.FIPAAgentManagement.ServiceDescription;
import jade.domain.FIPAException;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Tells the platform's tables, with what each agent has in the yellow pages. Agent thread only. */
public final class TablesTold {
  private static final Logger LOG = LoggerFactory.getLogger(TablesTold.class);
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);

  private final MaestroAgent supervisor;
  private final Containers containers;

  public TablesTold(MaestroAgent supervisor, Containers containers) {
    this.supervisor = supervisor;
    this.containers = containers;
  }

  /** The yellow pages are asked first. */
  public void list(ACLMessage message) {
    SearchConstraints all = new SearchConstraints();
    all.setMaxResults(-1L);
    // They know nothing of a stepped clock, which would go on while they look.
    Clock.Ticket asked = supervisor.clock().hold("the yellow pages");
    supervisor.ask(
        DFService.createRequestMessage(
            supervisor,
            supervisor.getDefaultDF(),
            FIPAManagementVocabulary.SEARCH,
            new DFAgentDescription(),
            all),
        ANSWER_WITHIN,
        answer -> {
          asked.close();
          supervisor.reply(
              message,
              ACLMessage.INFORM,
              containers.tables(services(answer)).toArray(Content[]::new));
        });
  }

  private static Map<String, Set<String>> services(ACLMessage answer) {
    Map<String, Set<String>> services = new TreeMap<>();
    if (answer.getPerformative() != ACLMessage.INFORM) {
      return services;
    }
    try {
      for (DFAgentDescription entry : DFService.decodeResult(answer.getContent())) {
        Set<String> types =
            services.computeIfAbsent(entry.getName().getLocalName(), n -> new TreeSet<>());
        for (var all = entry.getAllServices(); all.hasNext(); ) {
          types.add(((ServiceDescription) all.next()).getType());
        }
      }
    } catch (FIPAException e) {
      LOG.warn("The yellow pages answer unreadably: {}", e.getMessage());
    }
    return services;
  }
}
