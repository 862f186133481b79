package org.maestro.platform.guard;

import jade.core.AID;
import jade.core.AgentContainer;
import jade.core.BaseService;
import jade.core.Filter;
import jade.core.HorizontalCommand;
import jade.core.IMTPException;
import jade.core.Node;
import jade.core.NotFoundException;
import jade.core.Profile;
import jade.core.ProfileException;
import jade.core.Service;
import jade.core.ServiceException;
import jade.core.VerticalCommand;
import jade.core.messaging.GenericMessage;
import jade.core.messaging.MessagingSlice;
import jade.lang.acl.ACLMessage;
import jade.security.JADESecurityException;
import jade.util.leap.Properties;
import java.security.cert.CertificateEncodingException;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.runtime.Caller;
import org.maestro.rats.security.SecurityFilesException;

/**
 * A JADE kernel service that signs what agents of this container send, and refuses what reaches
 * them without the signature of the process in which its sender lives. JADE makes it by its class
 * name.
 */
public final class SignedMailService extends BaseService {
  /** JADE finds the class of the proxy by it. */
  static final String NAME = "org.maestro.platform.guard.SignedMail";

  /** JADE encodes what is sent at 10, and decodes what comes at 50. */
  private static final int BEFORE_ENCODING = 5;

  private static final int AFTER_DECODING = 60;

  private final String life = UUID.randomUUID().toString();
  private final AtomicLong numbers = new AtomicLong();
  private final ReplayWindow come = new ReplayWindow();
  private final Filter outgoing = new Outgoing();
  private final Filter incoming = new Incoming();
  private final Local local = new Local();

  // JADE makes a service by its class name, and says where it is before anything uses it.
  @SuppressWarnings("NullAway.Init")
  private AgentContainer container;

  @SuppressWarnings("NullAway.Init")
  private Guard guard;

  @SuppressWarnings("NullAway.Init")
  private Holders holders;

  @Override
  public String getName() {
    return NAME;
  }

  @Override
  public void init(AgentContainer owner, Profile profile) throws ProfileException {
    super.init(owner, profile);
    container = owner;
    try {
      guard = Guard.of(profile);
    } catch (SecurityFilesException unusable) {
      throw new ProfileException(unusable.getMessage(), unusable);
    }
    holders = new Holders(owner, guard::access, this::getSlice);
  }

  @Override
  public Filter getCommandFilter(boolean direction) {
    return direction == Filter.OUTGOING ? outgoing : incoming;
  }

  @Override
  public Class<?> getHorizontalInterface() {
    return SignedMailSlice.class;
  }

  @Override
  public Service.Slice getLocalSlice() {
    return local;
  }

  private static boolean isMail(VerticalCommand command) {
    return command.getName().equals(MessagingSlice.SEND_MESSAGE)
        && ((GenericMessage) command.getParam(1)).getACLMessage() != null;
  }

  private void refuse(VerticalCommand command, String sentence) {
    guard.refusals().log(sentence);
    command.setReturnValue(new JADESecurityException(sentence));
  }

  /** Signs; who writes another's name into the sender slot sends nothing. */
  private final class Outgoing extends Filter {
    Outgoing() {
      setPreferredPosition(BEFORE_ENCODING);
    }

    @Override
    protected boolean accept(VerticalCommand command) {
      if (!isMail(command)) {
        return true;
      }
      AID sender = (AID) command.getParam(0);
      ACLMessage message = ((GenericMessage) command.getParam(1)).getACLMessage();
      AID receiver = (AID) command.getParam(2);
      if (message.getSender() == null) {
        message.setSender(sender);
      }
      if (!message.getSender().equals(sender)) {
        refuse(
            command,
            "The agent %s sent a message in the name of %s; it was refused."
                .formatted(sender.getName(), message.getSender().getName()));
        return false;
      }
      Seal seal = Seal.of(message, receiver, life, numbers.incrementAndGet(), guard.access());
      message.setAllUserDefinedParameters(own(message.getAllUserDefinedParameters()));
      message.clearUserDefinedParameter(Caller.USER_SLOT);
      message.addUserDefinedParameter(Seal.SLOT, seal.write());
      return true;
    }

    /** JADE's copies of a message, one for each receiver, share what they carry beside. */
    private static Properties own(Properties shared) {
      Properties own = new Properties();
      own.putAll(shared);
      return own;
    }
  }

  /** Checks; what passes says whose process it came from. */
  private final class Incoming extends Filter {
    Incoming() {
      setPreferredPosition(AFTER_DECODING);
    }

    @Override
    protected boolean accept(VerticalCommand command) {
      if (!isMail(command)) {
        return true;
      }
      ACLMessage message = ((GenericMessage) command.getParam(1)).getACLMessage();
      AID receiver = (AID) command.getParam(2);
      message.clearUserDefinedParameter(Caller.USER_SLOT);
      Optional<Seal> seal = seal(message);
      Optional<String> objection =
          seal.isEmpty()
              ? Optional.of("it carries no signature")
              : objection(message, receiver, seal.get());
      if (objection.isPresent()) {
        refuse(
            command,
            "A message to %s in the name of %s was refused: %s."
                .formatted(receiver.getName(), name(message.getSender()), objection.get()));
        return false;
      }
      guard
          .access()
          .holder(seal.get().certificate())
          .ifPresent(user -> message.addUserDefinedParameter(Caller.USER_SLOT, user));
      return true;
    }

    /** JADE looks for the receiver elsewhere, and may come back here. */
    @Override
    protected void postProcess(VerticalCommand command) {
      if (isMail(command) && command.getReturnValue() instanceof NotFoundException) {
        seal(((GenericMessage) command.getParam(1)).getACLMessage())
            .ifPresent(seal -> come.undo(seal.life(), seal.number()));
      }
    }
  }

  private static Optional<Seal> seal(ACLMessage message) {
    return Optional.ofNullable(message.getUserDefinedParameter(Seal.SLOT)).flatMap(Seal::read);
  }

  private Optional<String> objection(ACLMessage message, AID receiver, Seal seal) {
    AID sender = message.getSender();
    if (sender == null) {
      return Optional.of("it has no sender");
    }
    Optional<String> user = guard.access().holder(seal.certificate());
    if (user.isEmpty()) {
      return Optional.of("it is signed by nobody of the site");
    }
    if (!seal.fits(message, receiver)) {
      return Optional.of("the signature of " + user.get() + " is not of this message");
    }
    if (!isOwnFailure(message, user.get()) && !holders.isHeldBy(sender, user.get())) {
      return Optional.of("it is signed by " + user.get() + ", where no agent of that name lives");
    }
    if (AgentNames.isCentral(sender.getLocalName())
        && !holders.isHeldBy(container.getAMS(), user.get())) {
      return Optional.of(
          "it is signed by " + user.get() + ", and only the main container has one of that name");
    }
    if (!come.come(seal.life(), seal.number())) {
      return Optional.of("it has come before");
    }
    if (isOrderOfGuest(message, receiver, user.get())) {
      return Optional.of(user.get() + " is a guest, and guests have JADE itself do nothing");
    }
    return Optional.empty();
  }

  /** JADE's own agent makes, moves and ends agents for whoever asks (A23). */
  private boolean isOrderOfGuest(ACLMessage message, AID receiver, String user) {
    return receiver.equals(container.getAMS())
        && message.getPerformative() == ACLMessage.REQUEST
        && guard.access().isGuest(user);
  }

  /** That a message cannot be delivered a container tells its own agents in the AMS's name. */
  private boolean isOwnFailure(ACLMessage message, String user) {
    return message.getPerformative() == ACLMessage.FAILURE
        && message.getSender().equals(container.getAMS())
        && user.equals(guard.access().user());
  }

  private static String name(AID agent) {
    return agent == null ? "nobody" : agent.getName();
  }

  /** The service as other containers ask it. */
  private final class Local implements Service.Slice {
    private static final long serialVersionUID = 1L;

    @Override
    public Service getService() {
      return SignedMailService.this;
    }

    @Override
    public Node getNode() throws ServiceException {
      try {
        return getLocalNode();
      } catch (IMTPException e) {
        throw new ServiceException("The container has no node", e);
      }
    }

    @Override
    public @Nullable VerticalCommand serve(HorizontalCommand command) {
      if (command.getName().equals(SignedMailSlice.CERTIFICATE)) {
        try {
          command.setReturnValue(guard.access().certificate().getEncoded());
        } catch (CertificateEncodingException e) {
          command.setReturnValue(e);
        }
      }
      return null;
    }
  }
}
