package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import jade.wrapper.StaleProxyException;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.time.Duration;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.CoordinatorAgent;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.GroupAgent;
import org.maestro.agents.HostAgent;
import org.maestro.agents.KnowledgeAgent;
import org.maestro.agents.PersonTrackerAgent;
import org.maestro.agents.SupervisorAgent;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.rats.time.SteppedClock;

/**
 * Who can make an agent, and what one that derives from the base of all sees of that (ADE, 3.1).
 */
class BirthTest {
  @TempDir static Path files;
  private static final AgentTime TIME = AgentTime.of(new SteppedClock());
  private static BareJade jade;

  @BeforeAll
  static void start() {
    jade = new BareJade("births", files);
  }

  @AfterAll
  static void end() {
    jade.close();
  }

  /** An agent of somebody who has read the base, and wants what it keeps. */
  public static final class Curious extends MaestroAgent {
    private static final long serialVersionUID = 1L;

    Curious(Birth birth) {
      super(birth, TIME);
    }

    /** As JADE wants it. */
    public Curious() {
      super();
    }

    @Override
    protected AgentTime timeHere() {
      return TIME;
    }

    static MethodHandles.Lookup sight() {
      return MethodHandles.lookup();
    }

    @Override
    protected void received(ACLMessage message) {
      throw new AssertionError("Nobody asks: " + message);
    }
  }

  @Test
  void aSubclassSeesNothingOfWhatTheBaseKeeps() {
    Curious curious = new Curious(jade.birth());
    assertThat(MaestroAgent.class.getDeclaredFields()).isNotEmpty();
    for (Field field : MaestroAgent.class.getDeclaredFields()) {
      assertThat(Modifier.isPrivate(field.getModifiers())).as(field.getName()).isTrue();
      assertThatThrownBy(() -> Curious.sight().unreflectGetter(field))
          .as(field.getName())
          .isInstanceOf(IllegalAccessException.class);
      assertThatThrownBy(() -> field.get(curious))
          .as(field.getName())
          .isInstanceOf(IllegalAccessException.class);
    }
    assertThat(MaestroAgent.class.getDeclaredClasses())
        .allMatch(inner -> Modifier.isPrivate(inner.getModifiers()));
    assertThat(
            Stream.of(MaestroAgent.class.getDeclaredMethods())
                .filter(
                    method -> !method.isSynthetic() && !Modifier.isPrivate(method.getModifiers()))
                .map(method -> method.getReturnType()))
        .noneMatch(type -> type == Birth.class)
        .allMatch(type -> type.isPrimitive() || Modifier.isPublic(type.getModifiers()));
  }

  @Test
  void withoutABirthNobodyMakesAnAgent() {
    assertThatThrownBy(() -> new DeskAgent(null, TIME))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("which a container of a platform attests");
    assertThatThrownBy(() -> new Curious(null)).isInstanceOf(IllegalStateException.class);
    assertThat(Birth.class.getDeclaredConstructors())
        .allMatch(constructor -> Modifier.isPrivate(constructor.getModifiers()));
    Stream.of(
            CoordinatorAgent.class,
            DeskAgent.class,
            GroupAgent.class,
            HostAgent.class,
            KnowledgeAgent.class,
            PersonTrackerAgent.class,
            SupervisorAgent.class)
        .flatMap(type -> Stream.of(type.getConstructors()))
        .forEach(
            constructor ->
                assertThat(constructor.getParameterTypes())
                    .as(constructor.toString())
                    .startsWith(Birth.class));
  }

  @Test
  void whatJadeMakesByItsClassNameNobodyElseMakes() throws Exception {
    assertThatThrownBy(GenericAgent::new)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("Only JADE makes an agent by its class name");
    assertThatThrownBy(Curious::new).isInstanceOf(IllegalStateException.class);
    Constructor<GenericAgent> constructor = GenericAgent.class.getConstructor();
    assertThatThrownBy(constructor::newInstance).hasCauseInstanceOf(IllegalStateException.class);
    assertThat(
            jade.main().createNewAgent("by-name", Curious.class.getName(), new Object[0]).getName())
        .startsWith("by-name@");
  }

  @Test
  void aBirthIsThatOfOneAgentAndOfItsPlatform() throws Exception {
    Birth birth = jade.birth();
    DeskAgent first = new DeskAgent(birth, TIME);
    assertThatThrownBy(() -> new DeskAgent(birth, TIME))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("that of one agent");
    try (BareJade other = new BareJade("elsewhere", files)) {
      assertThatThrownBy(() -> other.main().acceptNewAgent("desk", first))
          .isInstanceOf(StaleProxyException.class);
    }
    DeskAgent second = new DeskAgent(jade.birth(), TIME);
    jade.main().acceptNewAgent("desk", second).start();
    assertThat(second.awaitStart(Duration.ofSeconds(20))).isTrue();
  }

  @Test
  void noBirthIsAttestedByWhatIsNoContainerOfJade() {
    jade.core.AgentContainer feigned =
        (jade.core.AgentContainer)
            Proxy.newProxyInstance(
                BirthTest.class.getClassLoader(),
                new Class<?>[] {jade.core.AgentContainer.class},
                (proxy, method, arguments) ->
                    method.getReturnType() == boolean.class ? (Object) true : null);
    for (AgentContainer container :
        new AgentContainer[] {
          new AgentContainer(null, feigned, "births"), new AgentContainer(null, null, "births")
        }) {
      assertThatThrownBy(() -> Birth.of(container))
          .isInstanceOf(IllegalStateException.class)
          .hasMessageContaining("Only a container that is part of a platform");
    }
  }
}
