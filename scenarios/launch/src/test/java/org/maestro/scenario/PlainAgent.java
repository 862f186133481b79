package org.maestro.scenario;

import jade.content.lang.sl.SLCodec;
import jade.content.onto.basic.Action;
import jade.core.Agent;
import jade.core.Profile;
import jade.core.ProfileImpl;
import jade.core.Runtime;
import jade.core.behaviours.CyclicBehaviour;
import jade.core.behaviours.OneShotBehaviour;
import jade.domain.DFService;
import jade.domain.FIPAAgentManagement.DFAgentDescription;
import jade.domain.FIPAAgentManagement.Property;
import jade.domain.FIPAAgentManagement.SearchConstraints;
import jade.domain.FIPAAgentManagement.ServiceDescription;
import jade.domain.FIPANames;
import jade.domain.JADEAgentManagement.JADEManagementOntology;
import jade.domain.JADEAgentManagement.WhereIsAgentAction;
import jade.lang.acl.ACLCodec;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.StringACLCodec;
import jade.util.leap.Properties;
import jade.wrapper.AgentContainer;
import jade.wrapper.StaleProxyException;
import java.io.File;
import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.maestro.platform.letters.EnvelopeReader;

/**
 * An agent of JADE alone, in a container of its own that has none of MAESTRO's services: what a
 * guest brings along.
 */
public final class PlainAgent extends Agent {

  private static final long serialVersionUID = 1L;
  private static final long PATIENCE_SECONDS = 30;

  private final transient BlockingQueue<ACLMessage> replies = new LinkedBlockingQueue<>();

  /** The container of one plain agent. */
  record Guest(AgentContainer container, PlainAgent agent) implements AutoCloseable {
    @Override
    public void close() throws StaleProxyException {
      container.kill();
    }
  }

  /**
   * Joins a platform.
   *
   * @param platformName needed in the platform's own process only
   */
  static Guest join(Optional<String> platformName, int port, String container, String name)
      throws StaleProxyException {
    Properties properties = new Properties();
    properties.setProperty(Profile.MAIN, "false");
    properties.setProperty(Profile.MAIN_HOST, "127.0.0.1");
    properties.setProperty(Profile.LOCAL_HOST, "127.0.0.1");
    properties.setProperty(Profile.MAIN_PORT, String.valueOf(port));
    properties.setProperty(Profile.LOCAL_PORT, "0");
    properties.setProperty(Profile.CONTAINER_NAME, container);
    properties.setProperty(Profile.NO_MTP, "true");
    platformName.ifPresent(id -> properties.setProperty(Profile.PLATFORM_ID, id));
    AgentContainer joined = Runtime.instance().createAgentContainer(new ProfileImpl(properties));
    PlainAgent agent = new PlainAgent();
    joined.acceptNewAgent(name, agent).start();
    return new Guest(joined, agent);
  }

  /**
   * A platform of its own with this agent, which hears and writes to other platforms by HTTP.
   *
   * @param files where JADE writes down what the platform is
   */
  static Guest platform(String name, String agentName, Path files)
      throws IOException, StaleProxyException {
    Properties properties = new Properties();
    properties.setProperty(Profile.MAIN, "true");
    properties.setProperty(Profile.PLATFORM_ID, name);
    properties.setProperty(Profile.LOCAL_HOST, "127.0.0.1");
    properties.setProperty(Profile.LOCAL_PORT, String.valueOf(freePort()));
    properties.setProperty(
        Profile.MTPS,
        "jade.mtp.http.MessageTransportProtocol(http://127.0.0.1:%d/acc)".formatted(freePort()));
    properties.setProperty(Profile.FILE_DIR, files + File.separator);
    properties.setProperty("jade_mtp_http_parser", EnvelopeReader.class.getName());
    AgentContainer main = Runtime.instance().createMainContainer(new ProfileImpl(properties));
    PlainAgent agent = new PlainAgent();
    main.acceptNewAgent(agentName, agent).start();
    return new Guest(main, agent);
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  /** What a person types: FIPA's string form of a message. */
  static ACLMessage written(String text) throws ACLCodec.CodecException {
    return new StringACLCodec(new StringReader(text), new StringWriter()).decode();
  }

  @Override
  protected void setup() {
    addBehaviour(
        new CyclicBehaviour(this) {
          private static final long serialVersionUID = 1L;

          @Override
          public void action() {
            ACLMessage message = receive();
            if (message == null) {
              block();
            } else {
              replies.add(message);
            }
          }
        });
  }

  /** Sends the message as it is, but from this agent. */
  void say(ACLMessage message) {
    addBehaviour(
        new OneShotBehaviour(this) {
          private static final long serialVersionUID = 1L;

          @Override
          public void action() {
            message.setSender(getAID());
            send(message);
          }
        });
  }

  /** What the AMS knows of where an agent lives: the answer's text. */
  String whereIs(String localName) throws Exception {
    WhereIsAgentAction where = new WhereIsAgentAction();
    where.setAgentIdentifier(getAID(localName));
    ACLMessage question = new ACLMessage(ACLMessage.REQUEST);
    question.addReceiver(getAMS());
    question.setLanguage(FIPANames.ContentLanguage.FIPA_SL0);
    question.setOntology(JADEManagementOntology.NAME);
    getContentManager().registerLanguage(new SLCodec(), FIPANames.ContentLanguage.FIPA_SL0);
    getContentManager().registerOntology(JADEManagementOntology.getInstance());
    getContentManager().fillContent(question, new Action(getAMS(), where));
    say(question);
    ACLMessage answer = heard();
    return answer.getPerformative() == ACLMessage.AGREE
        ? heard().getContent()
        : answer.getContent();
  }

  /** The entries of the yellow pages with a service of this type. */
  List<DFAgentDescription> whoOffers(String type) throws Exception {
    ServiceDescription wanted = new ServiceDescription();
    wanted.setType(type);
    DFAgentDescription template = new DFAgentDescription();
    template.addServices(wanted);
    SearchConstraints all = new SearchConstraints();
    all.setMaxResults(-1L);
    say(DFService.createRequestMessage(this, getDefaultDF(), "search", template, all));
    return List.of(DFService.decodeResult(heard().getContent()));
  }

  /** Enters a service of this type into the yellow pages, for an agent of that name. */
  ACLMessage enter(String localName, String type) throws Exception {
    ServiceDescription service = new ServiceDescription();
    service.setType(type);
    service.setName(type);
    DFAgentDescription entry = new DFAgentDescription();
    entry.setName(getAID(localName));
    entry.addServices(service);
    say(DFService.createRequestMessage(this, getDefaultDF(), "register", entry, null));
    return heard();
  }

  /** What an entry says of a service. */
  static String property(DFAgentDescription entry, String type, String name) {
    for (var services = entry.getAllServices(); services.hasNext(); ) {
      ServiceDescription service = (ServiceDescription) services.next();
      for (var properties = service.getAllProperties();
          service.getType().equals(type) && properties.hasNext(); ) {
        Property property = (Property) properties.next();
        if (property.getName().equals(name)) {
          return String.valueOf(property.getValue());
        }
      }
    }
    return "";
  }

  /** The next message that came, waited for. */
  ACLMessage heard() throws InterruptedException {
    ACLMessage reply = replies.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
    if (reply == null) {
      throw new AssertionError("No reply came within " + PATIENCE_SECONDS + " s.");
    }
    return reply;
  }
}
