package org.maestro.architecture;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import jade.core.Agent;
import java.util.Arrays;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.runtime.MaestroAgent;

/** Who may know whom. The reasons stand in docs/decisions/0002-package-rules.md. */
@AnalyzeClasses(packages = "org.maestro", importOptions = ImportOption.DoNotIncludeTests.class)
class PackageRulesTest {
  private static final String COORDINATION = "org.maestro.coordination";
  private static final String[] ONTOLOGY = {"org.maestro.sl..", "org.maestro.ontology.."};
  private static final String[] BRIDGE = {"org.maestro.rats.."};
  private static final String[] DEVICES = {
    "org.maestro.hal..", "org.maestro.device..", "org.maestro.sim.."
  };
  private static final String[] CORE = {
    "org.maestro.knowledge..",
    "org.maestro.planning..",
    "org.maestro.coordination..",
    "org.maestro.members..",
    "org.maestro.persons..",
    "org.maestro.language..",
    "org.maestro.dialogue..",
    "org.maestro.diary..",
    "org.maestro.deployment..",
    "org.maestro.storage..",
    "org.maestro.text..",
    "org.maestro.agents..",
    "org.maestro.platform.."
  };
  private static final String[] TOP = {
    "org.maestro.assembly..",
    "org.maestro.console..",
    "org.maestro.random..",
    "org.maestro.chaos..",
    "org.maestro.launch..",
    "org.maestro.display..",
    "org.maestro.junit..",
    "org.maestro.experiment..",
    "org.maestro.picture..",
    "org.maestro.bench.."
  };

  @ArchTest
  static final ArchRule ONTOLOGY_KNOWS_NO_MODULE = from(ONTOLOGY, BRIDGE, DEVICES, CORE, TOP);

  @ArchTest
  static final ArchRule BRIDGE_KNOWS_NO_MODULE = from(BRIDGE, ONTOLOGY, DEVICES, CORE, TOP);

  @ArchTest static final ArchRule DEVICES_DO_NOT_KNOW_THE_CONTROL_LAYER = from(DEVICES, CORE, TOP);

  /** Neighbours only: hardware and its simulation are invisible to the control layer. */
  @ArchTest static final ArchRule CONTROL_LAYER_SEES_NO_HARDWARE = from(CORE, DEVICES, TOP);

  /**
   * The control layer talks to members by the link alone; the member's own side is not its
   * business.
   */
  @ArchTest
  static final ArchRule CONTROL_LAYER_SEES_ONLY_THE_LINK =
      noClasses()
          .that()
          .resideInAnyPackage(CORE)
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "org.maestro.rats.member..",
              "org.maestro.rats.transport..",
              "org.maestro.rats.broker..",
              "org.maestro.rats.gateway..");

  /** Devices are members made of drivers: they do not see MAESTRO's side of the bus. */
  @ArchTest
  static final ArchRule DEVICES_SEE_NO_LINK =
      noClasses()
          .that()
          .resideInAnyPackage(DEVICES)
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.maestro.rats.link..", "org.maestro.rats.broker..");

  /**
   * A real driver can take the simulated one's place, because nobody below knows the simulation.
   */
  @ArchTest
  static final ArchRule DEVICES_ARE_IGNORANT_OF_THE_SIMULATION =
      noClasses()
          .that()
          .resideInAnyPackage("org.maestro.hal..", "org.maestro.device..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.maestro.sim..");

  /**
   * Lamp, robot and door: one class of agents speaks for them all (Three-layered architecture,
   * abstract and 3.3.2; M2, M69).
   */
  @ArchTest
  static final ArchRule ONE_CLASS_OF_AGENTS_SPEAKS_FOR_DEVICES =
      noClasses()
          .that()
          .areAssignableTo(Agent.class)
          .and()
          .areNotAssignableTo(GenericAgent.class)
          .should()
          .dependOnClassesThat()
          .haveFullyQualifiedName("org.maestro.agents.device.MemberProxy");

  /**
   * Bookkeeping and credentials of all agents are kept in one place, whatever they do (ADE, 3.1;
   * A19). What our agents are measured against derives from JADE's.
   */
  @ArchTest
  static final ArchRule ALL_AGENTS_HAVE_ONE_BASE =
      classes()
          .that()
          .areAssignableTo(Agent.class)
          .and()
          .resideOutsideOfPackage("org.maestro.bench")
          .should()
          .beAssignableTo(MaestroAgent.class);

  @ArchTest
  static final ArchRule THE_BASE_OF_AGENTS_SHOWS_NO_FIELD =
      fields().that().areDeclaredIn(MaestroAgent.class).should().bePrivate();

  /** Nobody gets round what lets others in by overriding it (ADE, 3.1; A22). */
  @ArchTest
  static final ArchRule WHAT_LETS_OTHERS_IN_CANNOT_BE_DERIVED_FROM =
      classes()
          .that()
          .resideInAnyPackage(
              "org.maestro.agents.supervision",
              "org.maestro.agents.pulse",
              "org.maestro.platform.guard")
          .or()
          .haveNameMatching("org\\.maestro\\.agents\\.(Supervisor|Host|Knowledge)Agent")
          .or()
          .haveNameMatching("org\\.maestro\\.platform\\.(Supervision|Deployer|Arrivals)")
          .or()
          .haveNameMatching("org\\.maestro\\.agents\\.device\\.(Rights|RequestGuard)")
          .or()
          .haveFullyQualifiedName("org.maestro.agents.runtime.Birth")
          .or()
          .haveFullyQualifiedName("org.maestro.ontology.home.AccessList")
          .and()
          .areNotInterfaces()
          .should()
          .haveModifier(JavaModifier.FINAL);

  @ArchTest
  static final ArchRule JADE_STAYS_IN_PLATFORM_AND_AGENTS =
      noClasses()
          .that()
          .resideOutsideOfPackages(
              "org.maestro.platform..",
              "org.maestro.agents..",
              "org.maestro.console.questions..",
              "org.maestro.launch..",
              "org.maestro.bench..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("jade..");

  /** Whoever asks by HTTP starts at once: nothing of the platform is loaded. */
  @ArchTest
  static final ArchRule THE_CONSOLES_CLIENT_KNOWS_NO_PLATFORM =
      noClasses()
          .that()
          .resideInAPackage("org.maestro.console.client")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(CORE);

  @ArchTest
  static final ArchRule THE_SERVER_STAYS_IN_THE_CONSOLE =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.maestro.console")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("io.javalin..", "org.eclipse.jetty..");

  @ArchTest
  static final ArchRule PAHO_STAYS_IN_THE_TRANSPORT =
      noClasses()
          .that()
          .resideOutsideOfPackages("org.maestro.rats.transport..", "org.maestro.bench..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.eclipse.paho..");

  @ArchTest
  static final ArchRule ARTEMIS_STAYS_IN_THE_BROKER =
      noClasses()
          .that()
          .resideOutsideOfPackages("org.maestro.rats.broker..", "org.maestro.bench..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.apache.activemq..", "org.apache.artemis..");

  @ArchTest
  static final ArchRule THE_HEART_IS_FREE_OF_JENA =
      noClasses()
          .that()
          .resideInAnyPackage(
              "org.maestro.sl..",
              "org.maestro.planning..",
              "org.maestro.coordination..",
              "org.maestro.members..",
              "org.maestro.persons..",
              "org.maestro.deployment..",
              "org.maestro.agents..",
              "org.maestro.platform..",
              "org.maestro.rats..",
              "org.maestro.hal..",
              "org.maestro.device..",
              "org.maestro.launch..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.apache.jena..");

  @ArchTest
  static final ArchRule THE_LANGUAGE_STANDS_ALONE =
      noClasses()
          .that()
          .resideInAnyPackage("org.maestro.sl..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.maestro.ontology..");

  /** The heart is driven by a unit test without agents. */
  @ArchTest
  static final ArchRule THE_HEART_KNOWS_NO_AGENTS =
      noClasses()
          .that()
          .resideInAnyPackage(
              "org.maestro.knowledge..",
              "org.maestro.planning..",
              "org.maestro.coordination..",
              "org.maestro.persons..",
              "org.maestro.language..",
              "org.maestro.dialogue..",
              "org.maestro.diary..",
              "org.maestro.deployment..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.maestro.agents..", "org.maestro.platform..");

  /** What moves a goal on is the Coordinator's own business. */
  @ArchTest
  static final ArchRule OF_COORDINATION_ITS_API_AND_THE_COORDINATOR_ARE_SEEN =
      noClasses()
          .that()
          .resideOutsideOfPackage(COORDINATION + "..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(within("facts", "lessons", "story", "recovery", "contention"))
          .orShould()
          .dependOnClassesThat()
          .resideInAnyPackage(
              within(
                  "allocation",
                  "achievement",
                  "maintenance",
                  "scripts",
                  "worth",
                  "agenda",
                  "undoing"));

  @ArchTest
  static final ArchRule COORDINATIONS_API_KNOWS_NONE_OF_ITS_PARTS =
      inCoordination(
          "api", "facts", "lessons", "story", "journal", "recovery", "contention", "achievement");

  @ArchTest
  static final ArchRule FACTS_ARE_NOT_TOLD_YET =
      inCoordination(
          "facts", "lessons", "story", "journal", "recovery", "contention", "achievement");

  @ArchTest
  static final ArchRule A_STORY_DECIDES_NOTHING =
      inCoordination("story", "recovery", "contention", "allocation", "achievement", "maintenance");

  @ArchTest
  static final ArchRule GOALS_BESIDE_EACH_OTHER_DO_NOT_SEE_HOW_THEY_ARE_REACHED =
      inCoordination("contention", "allocation", "achievement", "maintenance");

  @ArchTest
  static final ArchRule GOALS_THAT_ARE_REACHED_KNOW_NONE_THAT_ARE_HELD =
      inCoordination("achievement", "maintenance");

  @ArchTest
  static final ArchRule GOALS_THAT_ARE_HELD_DO_NOT_KNOW_HOW_ONE_IS_REACHED =
      inCoordination("maintenance", "achievement");

  @ArchTest
  static final ArchRule WORTH_DECIDES_NOTHING =
      inCoordination(
          "worth", "contention", "allocation", "achievement", "maintenance", "scripts", "story");

  @ArchTest
  static final ArchRule GOALS_DO_NOT_KNOW_THAT_THEY_ARE_PARTS_OF_SCRIPTS =
      inCoordination("achievement", "scripts");

  @ArchTest
  static final ArchRule SCRIPTS_DO_NOT_KNOW_HOW_GOALS_ARE_HELD =
      inCoordination("scripts", "maintenance", "allocation");

  @ArchTest
  static final ArchRule WHAT_BEGINS_GOALS_DOES_NOT_KNOW_HOW_THEY_ARE_PURSUED =
      inCoordination("agenda", "achievement", "maintenance", "allocation", "scripts");

  @ArchTest
  static final ArchRule THE_COMMAND_LINE_IS_KNOWN_TO_NOBODY =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.maestro.launch..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.maestro.launch..");

  /** In Turkish FAILED has no dot in small letters. */
  @ArchTest
  static final ArchRule SMALL_AND_CAPITAL_LETTERS_ARE_THE_SAME_IN_ALL_LANGUAGES =
      noClasses()
          .should()
          .callMethod(String.class, "toLowerCase")
          .orShould()
          .callMethod(String.class, "toUpperCase");

  @ArchTest
  static final ArchRule PACKAGES_FORM_NO_CIRCLE =
      slices().matching("org.maestro.(**)").should().beFreeOfCycles();

  private static ArchRule inCoordination(String part, String... unknown) {
    return noClasses()
        .that()
        .resideInAPackage(COORDINATION + "." + part)
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(within(unknown));
  }

  private static String[] within(String... parts) {
    return Arrays.stream(parts).map(part -> COORDINATION + "." + part).toArray(String[]::new);
  }

  private static ArchRule from(String[] packages, String[]... forbidden) {
    return noClasses()
        .that()
        .resideInAnyPackage(packages)
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(Arrays.stream(forbidden).flatMap(Arrays::stream).toArray(String[]::new))
        .allowEmptyShould(true);
  }
}
