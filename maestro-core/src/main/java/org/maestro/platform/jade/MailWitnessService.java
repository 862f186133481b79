package org.maestro.platform.jade;

import jade.core.AID;
import jade.core.AgentContainer;
import jade.core.BaseService;
import jade.core.Filter;
import jade.core.Profile;
import jade.core.ProfileException;
import jade.core.ProfileImpl;
import jade.core.VerticalCommand;
import jade.core.messaging.GenericMessage;
import jade.core.messaging.MessagingSlice;
import jade.lang.acl.ACLMessage;
import org.maestro.rats.time.HybridClock;

/**
 * A JADE kernel service that lets the {@link MailWitness} see the mail of its container. JADE makes
 * it by its class name.
 */
public final class MailWitnessService extends BaseService {
  /** Before others sign it, encode it, or take it on. */
  private static final int FIRST_TO_SEE = 4;

  /** JADE decodes what comes at 50. */
  private static final int AFTER_DECODING = 61;

  private final Filter outgoing = new Mail(FIRST_TO_SEE, this::sent);
  private final Filter incoming = new Mail(AFTER_DECODING, this::delivered);
  private MailWitness witness = new MailWitness(HybridClock.ofProcess());

  // JADE makes a service by its class name, and says where it is before anything uses it.
  @SuppressWarnings("NullAway.Init")
  private AgentContainer container;

  @Override
  public String getName() {
    return "org.maestro.MailWitness";
  }

  @Override
  public void init(AgentContainer owner, Profile profile) throws ProfileException {
    super.init(owner, profile);
    container = owner;
    if (profile instanceof ProfileImpl all
        && all.getProperties().get(MailWitness.KEY) instanceof MailWitness shared) {
      witness = shared;
    }
    witness.begin(owner);
  }

  @Override
  public void shutdown() {
    witness.end(container);
    super.shutdown();
  }

  @Override
  public Filter getCommandFilter(boolean direction) {
    return direction == Filter.OUTGOING ? outgoing : incoming;
  }

  private void sent(AID sender, ACLMessage message, AID receiver) {
    witness.sent(sender, message, receiver);
  }

  private void delivered(AID sender, ACLMessage message, AID receiver) {
    witness.delivered(sender, message, receiver);
  }

  private interface Seen {
    void message(AID sender, ACLMessage message, AID receiver);
  }

  private static final class Mail extends Filter {
    private final Seen seen;

    Mail(int position, Seen seen) {
      this.seen = seen;
      setPreferredPosition(position);
    }

    @Override
    protected boolean accept(VerticalCommand command) {
      if (command.getName().equals(MessagingSlice.SEND_MESSAGE)) {
        ACLMessage message = ((GenericMessage) command.getParam(1)).getACLMessage();
        if (message != null) {
          seen.message((AID) command.getParam(0), message, (AID) command.getParam(2));
        }
      }
      return true;
    }
  }
}
