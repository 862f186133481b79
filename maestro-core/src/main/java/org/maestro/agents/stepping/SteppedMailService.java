package org.maestro.agents.stepping;

import jade.core.AID;
import jade.core.Agent;
import jade.core.BaseService;
import jade.core.Filter;
import jade.core.ServiceHelper;
import jade.core.VerticalCommand;
import jade.core.messaging.GenericMessage;
import jade.core.messaging.MessagingSlice;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * A JADE kernel service that hands the messages of stepped agents to their {@link SteppedMail}.
 * JADE makes it by its class name, in every container of this process.
 */
public final class SteppedMailService extends BaseService {
  public static final String NAME = "org.maestro.SteppedMail";

  private final Map<String, SteppedMail> mailBySender = new ConcurrentHashMap<>();
  private final Filter outgoing = new Outgoing();

  /** The service helper by which an agent registers with the service. */
  public interface Registration extends ServiceHelper {
    /** From now on, what this agent sends goes by the given mail. */
    void register(Agent agent, SteppedMail mail);
  }

  @Override
  public String getName() {
    return NAME;
  }

  @Override
  public @Nullable Filter getCommandFilter(boolean direction) {
    return direction == Filter.OUTGOING ? outgoing : null;
  }

  @Override
  public ServiceHelper getHelper(Agent agent) {
    return new Registration() {
      @Override
      public void init(Agent owner) {
        // The registration comes by its own method.
      }

      @Override
      public void register(Agent owner, SteppedMail mail) {
        mailBySender.put(owner.getName(), mail);
      }
    };
  }

  /** The container has no agents any more; JADE keeps this service. */
  @Override
  public void shutdown() {
    super.shutdown();
    mailBySender.clear();
  }

  private final class Outgoing extends Filter {
    @Override
    protected boolean accept(VerticalCommand command) {
      if (!command.getName().equals(MessagingSlice.SEND_MESSAGE)) {
        return true;
      }
      SteppedMail mail = mailBySender.get(((AID) command.getParam(0)).getName());
      return mail == null
          || !mail.take(
              ((GenericMessage) command.getParam(1)).getACLMessage(), (AID) command.getParam(2));
    }
  }
}
