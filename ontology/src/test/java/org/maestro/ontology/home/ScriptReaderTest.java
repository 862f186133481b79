package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.ontology.validation.Fault;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** Action scripts in a home file: what is read, and what is told of those that could not be run. */
class ScriptReaderTest {
  private static final String BOB =
      ShippedHomes.text("bob.ttl")
          + "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n"
          + """
            home:prepareRoom a maestro:Script ; rdfs:label "prepare a room"@en ;
              maestro:arguments ( "?room - Zone" "?who - Person" ) ; maestro:benefit 60 ;
              maestro:chance 0.9 ; maestro:allowed "PT10M"^^xsd:duration ;
              maestro:body \"""(seq (achieve (>= (illuminance ?room) 72))
                (try (do move rose :to ?room) (recover (run dim ?room 0.5))))\""" .
            home:dim a maestro:Script ; maestro:arguments ( "?room - Zone" "?level - xsd:double" ) ;
              maestro:benefit "(* 10 ?level)" ;
              maestro:body \"""(seq
                (foreach (?l - Lamp) (inside ?l ?room) (do adjustLight ?l :level ?level))
                (let ?lux (value (illuminance ?room)) (if (> ?lux 500) (run dim ?room 0)))
                (let ?lamp (one (?l - Lamp) (inside ?l ?room)) (do adjustLight ?lamp :level 0.25))
                (wait ?level) (return ?room))\""" .
            """;

  private static final String PRINTED =
      """
      home:measured a maestro:Script ; maestro:arguments ( "?room - Zone" ) ;
        maestro:body "(let ?lux (value (illuminance ?room)) (return ?lux))" .
      home:evening a maestro:Script ; maestro:arguments ( "?room - Zone" "?who - Person" ) ;
        maestro:printed \"""script: evening
          agent: room
          agent: who
          name: lux
          lux := measured(room)
          prepareRoom(room, who)
          dim(room, lux)
          dim(zone-b, 0.5)\""" .
      """;

  @Test
  void aScriptIsReadWithAllThatIsSaidOfIt() {
    Home home = load(BOB);

    assertThat(home.scripts()).containsOnlyKeys("dim", "prepareRoom");
    Script prepare = home.scripts().get("prepareRoom");
    assertThat(prepare.label()).isEqualTo("prepare a room");
    assertThat(prepare.parameters())
        .containsExactly(SlParser.variable("?room - Zone"), SlParser.variable("?who - Person"));
    assertThat(prepare.benefit()).contains(SlParser.expression("60"));
    assertThat(prepare.chance()).contains(0.9);
    assertThat(prepare.allowed()).contains(Duration.ofMinutes(10));
    assertThat(SlPrinter.print(prepare.body()))
        .isEqualTo(
            "(seq (achieve (>= (illuminance ?room) 72))"
                + " (try (do move rose :to ?room) (recover (run dim ?room 0.5))))");

    Script dim = home.scripts().get("dim");
    assertThat(dim.label()).isEqualTo("dim");
    assertThat(dim.parameters().get(1)).isEqualTo(SlParser.variable("?level - double"));
    assertThat(dim.benefit()).contains(SlParser.expression("(* 10 ?level)"));
    assertThat(dim.chance()).isEmpty();
    assertThat(dim.allowed()).isEmpty();
  }

  @Test
  void aScriptIsNoThingAndNoWord() {
    Home home = load(BOB);

    assertThat(home.individuals()).isEqualTo(ShippedHomes.bob().individuals());
    assertThat(home.vocabulary()).isEqualTo(ShippedHomes.bob().vocabulary());
    assertThat(home.words()).isEqualTo(ShippedHomes.bob().words());
    assertThat(
            new DescriptionReader(home.vocabulary())
                .read(new DescriptionWriter(home).write(home.devices().get("rose")), "rose"))
        .isEqualTo(home.devices().get("rose"));
  }

  @Test
  void homesWithoutScriptsHaveNone() {
    assertThat(ShippedHomes.bob().scripts()).isEmpty();
    assertThat(ShippedHomes.arena().scripts()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "(seq (wait 1) (if (open door-ab) (run again)))",
        "(while (open door-ab) (run again))",
        "(foreach (?l - Lamp) (> (level ?l) 0) (run again))",
        "(try (achieve (open door-ab)) (recover (run again)))",
        "(seq (if (open door-ab) (return door-ab)) (run again))",
        "(seq (if (open door-ab) (fail \\\"open\\\")) (run again))",
        "(let ?lux (value (illuminance zone-a)) (seq (if (> ?lux 9) (return 1)) (run again)))",
        "(achieve (exists (?p - Person) (forall (?l - Lamp) (not (canSee ?l ?p)))))",
        "(do move rose :from zone-a :to zone-b)",
        "(foreach (?r - RechargingRobot) (< (charge ?r) 1) (do recharge ?r))",
        "(assert (forall (?l - Lamp) (when (> (level ?l) 0.5) (assign (level ?l) 0.5))))",
        "(let ?given (run dim zone-a 0.5) (achieve (in Cup ?given)))",
        "(hold rose \\\"arm\\\" (wait 30) (achieve (in rose zone-a)))",
        "(while (open door-ab) (hold rose \\\"base\\\"))",
        "(say room-a \\\"Good night.\\\")",
        "(foreach (?p - Person) (in ?p zone-a) (say ?p \\\"Hello,\\\" ?p))",
        "(tell CCA (initCNP (:goal (canSee ?agent Cup))))",
        "(let ?n (value (level lamp-a1)) (seq (express glad ?n) (express \\\"at ease\\\" 0)))",
        "(seq (look Cup) (look zone-a) (look Bob) (look rose))",
        "(foreach (?i - Item) (in ?i zone-a) (look ?i))",
        "(seq (ask Bob \\\"Which room?\\\" ?room Zone) (do move rose :to ?room) (wait 1))",
        "(ask room-a \\\"Shall I?\\\" ?yes boolean (if (= ?yes true) (achieve (open door-ab))))",
        "(seq (ask Bob \\\"How much?\\\" ?n (slider 0 1 0.1 \\\"no\\\" \\\"all\\\")) (wait ?n))",
        "(seq (ask Bob \\\"Who?\\\" ?who2 (choice Bob \\\"nobody\\\")) (if (= ?who2 \\\"nobody\\\") (wait 1)))",
        "(seq (ask Bob \\\"How long?\\\" ?s double) (ask Bob \\\"And\\\" ?s \\\"more?\\\" ?t double)"
            + " (wait ?t))",
        "(tell somebody (whatever it \\\"is\\\"))",
        "(foreach (?r - RechargingRobot) (in ?r zone-a) (hold ?r \\\"base\\\" (wait 30)))",
      })
  void whatIsFine(String body) {
    String text = script("again", "", body);
    assertThat(load(text).scripts()).containsKey("again");
  }

  @Test
  void whatOnlySomeKindsOfADeviceTakeIsFineOfThem() {
    String white = script("again", "", "(do adjustLight lamp-a1 :white 2700)");

    assertFault(white, "gives adjustLight the unknown parameter :white; it takes :level");
    assertThat(load(white.replace("lamp-a1 a :Lamp", "lamp-a1 a :TunableLamp")).scripts())
        .containsKey("again");
    assertThat(
            load(script("again", "\"?l - TunableLamp\"", "(do adjustLight ?l :white 2700)"))
                .scripts())
        .containsKey("again");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        // the language
        "(achive (open door-ab)) | body \"(achive (open door-ab))\" is not MAESTRO-SL: at column 1"
            + " stands \"(achive ...)\"; write a step, such as (achieve (in Cup zone-a))",
        // names
        "(achieve (opn door-ab))"
            + " | body uses the unknown predicate opn; write open, if that is meant",
        "(achieve (>= (iluminance zone-a) 72))"
            + " | body uses the unknown fluent iluminance; write illuminance, if that is meant",
        "(wait (in Cup zone-c)) | body names zone-c, which is not described; write zone-a",
        "(if (open Xylophone) (wait 1)) | body names Xylophone, which is not described;"
            + " describe it in the home, or write ?Xylophone for a parameter",
        "(foreach (?l - Lam) (> (level ?l) 0) (wait 1))"
            + " | body uses the unknown class Lam; write Lamp, if that is meant",
        "(assert (opened door-ab)) | body uses the unknown predicate opened",
        "(assert (passable zone-a zone-b)) | body sets passable, which follows from other facts",
        "(assert (forall (?l - Lamp) (sense (level ?l)))) | body asserts what is to be sensed",
        "(while (illuminance zone-a) (wait 1))"
            + " | body uses the number illuminance as if it were true or false",
        // variables
        "(achieve (in Cup ?rom)) | body uses ?rom, which nothing binds; write ?room",
        "(seq (foreach (?l - Lamp) (> (level ?l) 0) (wait 1)) (do adjustLight ?l :level 0))"
            + " | body uses ?l, which nothing binds",
        "(seq (let ?x (value (illuminance zone-a)) (wait 1)) (wait ?x))"
            + " | body uses ?x, which nothing binds",
        "(let ?x (one (?l - Lamp) (> (level ?l) 0)) (do adjustLight ?l :level 0))"
            + " | body uses ?l, which nothing binds",
        "(return ?x) | body uses ?x, which nothing binds",
        "(do move rose :to ?x) | body uses ?x, which nothing binds",
        "(foreach (?l) (Lamp ?l) (wait 1))"
            + " | body goes through everything for ?l; give it a class, such as (?l - Thing)",
        "(let ?x (one (?l) (Lamp ?l)) (wait 1)) | body goes through everything for ?l",
        // classes
        "(achieve (in Cup ?who))"
            + " | body gives ?who, a Person, where a Place is wanted; write (in ?x - Thing",
        "(foreach (?p - Person) (in ?p zone-a) (achieve (>= (illuminance ?p) 72)))"
            + " | body gives ?p, a Person, where a Location is wanted",
        "(let ?x (one (?p - Person) (in ?p zone-a)) (achieve (open ?x)))"
            + " | body gives ?x, a Person, where a Door is wanted",
        "(let ?x (value (illuminance zone-a)) (achieve (in Cup ?x)))"
            + " | body gives ?x, a decimal, where a Place is wanted",
        "(achieve (open zone-a)) | body names zone-a where a Door is wanted, and it is none",
        // other scripts
        "(run prepaireRoom zone-a Bob)"
            + " | body runs the unknown script prepaireRoom; write prepareRoom, if that is meant",
        "(run sing) | body runs the unknown script sing; describe it as a maestro:Script",
        "(run prepareRoom zone-a) | body gives prepareRoom 1 arguments;"
            + " write (run prepareRoom ?room - Zone ?who - Person)",
        "(run prepareRoom ?who zone-a) | body gives ?who for ?room of prepareRoom, which cannot be"
            + " that; write (run prepareRoom ?room - Zone ?who - Person)",
        "(run prepareRoom zone-a Cup) | body gives Cup for ?who of prepareRoom, which cannot be",
        "(run dim zone-a \\\"half\\\") | body gives \"half\" for ?level of dim, which cannot be",
        "(let ?x (run dim zone-a Bob) (wait 1)) | body gives Bob for ?level of dim, which cannot",
        "(seq (wait 1) (run faulty zone-a Bob)) | body runs itself without an end (faulty, faulty);"
            + " put one of these runs under a condition, such as (if ... (run faulty ...))",
        "(try (par (wait 1) (let ?x (run faulty ?room ?who) (wait 1))) (recover (wait 1)))"
            + " | body runs itself without an end (faulty, faulty)",
        "(try (wait 1) (finally (run faulty ?room ?who))) | body runs itself without an end",
        // features
        "(do moove rose) | body calls the unknown feature moove; write move, if that is meant",
        "(do whistle rose) | body calls the unknown feature whistle; name one of adjustLight,",
        "(do ring rose) | body calls ring, which no device offers; say which class of devices does",
        "(do move Cup) | body calls move of Cup, which is no device; name a device that offers it,"
            + " such as rose",
        "(do move 7) | body calls move of 7, which is no device",
        "(do move lamp-a1)"
            + " | body calls move of lamp-a1, which does not offer it; name a device that offers",
        "(do move ?who) | body calls move of ?who, which does not offer it; name a device that",
        "(do move ros) | body names ros, which is not described; write rose, if that is meant",
        "(do move rose :too zone-a)"
            + " | body gives move the unknown parameter :too; write :to, if that is meant",
        "(do move rose :speed 3)"
            + " | body gives move the unknown parameter :speed; it takes :from, :onward, :to",
        "(do openDoor gate :wide true)"
            + " | body gives openDoor the unknown parameter :wide; it takes none",
        "(do move rose :to Cup) | body gives Cup for :to of move, which cannot be that;"
            + " give it a Zone",
        "(do move rose :to ?who) | body gives ?who for :to of move, which cannot be that",
        "(do move rose :to \\\"zone-a\\\") | body gives \"zone-a\" for :to of move, which cannot be",
        "(do adjustLight lamp-a1 :level 0.6) | body gives 0.6 for :level of adjustLight, which"
            + " cannot be that; give it one of 0, 0.25, 0.5, 1",
        "(do adjustLight lamp-a1 :level true) | body gives true for :level of adjustLight",
        // what is kept
        "(hold rose \\\"base\\\") | body \"(hold rose \"base\")\" is not MAESTRO-SL: at column 18 stands"
            + " \")\"; write a member, its component in quotes, and steps",
        "(hold rose base (wait 1)) | body \"(hold rose base (wait 1))\" is not MAESTRO-SL: at column 12"
            + " stands \"base\"; write a text in quotes",
        "(hold rose \\\"bases\\\" (wait 1))"
            + " | body holds the unknown component bases of rose; write base, if that is meant",
        "(hold rose \\\"wing\\\" (wait 1))"
            + " | body holds the unknown component wing of rose; it has arm, base",
        "(hold Cup \\\"base\\\" (wait 1)) | body holds base of Cup, which has no components",
        "(hold ?who \\\"base\\\" (wait 1)) | body holds base of ?who, which has no components",
        "(hold ros \\\"base\\\" (wait 1)) | body names ros, which is not described; write rose",
        "(hold rose \\\"base\\\" (do moove rose)) | body calls the unknown feature moove",
        "(hold rose \\\"base\\\" (wait 1) (run faulty ?room ?who)) | body runs itself without an end",
        // what is said
        "(say Cup \\\"Hello.\\\") | body speaks to Cup, which is neither a person nor a room;"
            + " name one that is a maestro:Listener, such as ",
        "(say ?room \\\"Hello.\\\") | body speaks to ?room, which is neither a person nor a room",
        "(say Bop \\\"Hello.\\\") | body names Bop, which is not described; write Bob",
        "(say Bob ?whom) | body uses ?whom, which nothing binds; write ?who",
        "(ask Cup \\\"Well?\\\" ?x) | body speaks to Cup, which is neither a person nor a room",
        "(ask Bob \\\"Well?\\\" ?x Zonne) | body asks for an answer of the unknown class Zonne;"
            + " write Zone, if that is meant",
        "(ask Bob \\\"Well?\\\" ?x number) | body asks for an answer of the unknown class number;"
            + " write a class, or one of string, boolean, double, decimal, integer",
        "(seq (ask Bob \\\"Well?\\\" ?x) (do move rose :to ?x))"
            + " | body gives ?x for :to of move, which cannot be that; give it a Zone",
        "(seq (ask Bob \\\"Well?\\\" ?x Person) (achieve (in Cup ?x)))"
            + " | body gives ?x, a Person, where a Place is wanted",
        "(seq (if (open door-ab) (ask Bob \\\"Well?\\\" ?x)) (return ?x))"
            + " | body uses ?x, which nothing binds",
        "(seq (ask Bob \\\"Well?\\\" ?x) (run faulty ?room ?who)) | body runs itself without an end",
        "(ask Bob \\\"Well?\\\" ?x (choice \\\"a\\\"))"
            + " | body has a choice of 1; write from two to 50 options",
        "(ask Bob \\\"Well?\\\" ?x (choice Bob Cup Bob)) | body has the same option twice in a choice",
        "(ask Bob \\\"Well?\\\" ?x (choice Bop \\\"nobody\\\")) | body names Bop, which is not described",
        "(ask Bob \\\"Well?\\\" ?x (slider 7 1 1)) | body has a slider from 7 to 1 by steps of 1; let whole"
            + " steps, 10000 at most, lead from the lowest number to the highest",
        "(ask Bob \\\"Well?\\\" ?x (slider 0 1 0.3)) | body has a slider from 0 to 1 by steps of 0.3",
        "(ask Bob \\\"Well?\\\" ?x (slider 0 1 0)) | body has a slider from 0 to 1 by steps of 0",
        "(seq (ask Bob \\\"Well?\\\" ?x (slider 0 1 0.5)) (do move rose :to ?x))"
            + " | body gives ?x for :to of move, which cannot be that",
        "(express glad 3) | body expresses something by 3, which is no number from 0 to 1;"
            + " write how much, such as (express glad 0.8)",
        "(express glad very) | body names very, which is not described",
        "(express glad ?who) | body expresses something by ?who, which is no number from 0 to 1",
        "(express glad ?much) | body uses ?much, which nothing binds",
        "(express 1 1) | body expresses 1, which is no word; write a word, such as",
        "(look room-a) | body looks at room-a, of which there is nothing to see; name a thing that",
        "(look ?level) | body uses ?level, which nothing binds",
        "(let ?n (value (illuminance zone-a)) (look ?n)) | body looks at ?n, of which there is nothing",
        "(look 3) | body looks at 3, of which there is nothing to see",
        "(look Cupp) | body names Cupp, which is not described; write Cup",
        "(tell 7 (ping)) | body tells 7 something, which is no agent; write the name of an agent",
        "(tell ?x (ping)) | body uses ?x, which nothing binds",
        "(tell CCA (initCNP (:goal (nextTo Cup ?whom))))"
            + " | body uses ?whom in a message, which nothing binds; write ?who, if that is meant",
        "(tell CCA (initCNP (:goal (nextTo Cup)) | body \"(tell CCA (initCNP (:goal (nextTo Cup))\""
            + " is not MAESTRO-SL",
        "(do adjustLight lamp-a1 :level ?room) | body gives ?room for :level of adjustLight",
      })
  void aFaultyBody(String body, String expected) {
    String others =
        """
        :ring a maestro:Action ; rdfs:label "ring"@en ; maestro:cost "1" .
        home:gate a :DrivenDoor ; rdfs:label "gate"@en ; :side home:zone-a , home:zone-b ;
          maestro:openingFrom "3 0.2" ; maestro:openingTo "3 1.2" .
        """;
    assertFault(
        script("faulty", "\"?room - Zone\" \"?who - Person\"", body) + others,
        "faulty maestro:" + expected);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "\"?room - Zone\" | \"?room - Zonne\" | prepareRoom maestro:arguments use the unknown class"
            + " Zonne; write Zone, if that is meant",
        "\"?room - Zone\" | \"?room\" | prepareRoom maestro:arguments does not say what ?room is;"
            + " write its class or datatype, such as \"?room - Thing\"",
        "\"?who - Person\" | \"?room - Person\" | prepareRoom maestro:arguments names ?room twice;"
            + " give one of both another name",
        "\"?who - Person\" | \"who\" | prepareRoom maestro:arguments \"who\" is not MAESTRO-SL",
        "maestro:benefit 60 | maestro:benefit -5"
            + " | prepareRoom maestro:benefit \"-5\" is less than nothing; write the seconds",
        "maestro:benefit 60 | maestro:benefit \"(* 2 ?much)\""
            + " | prepareRoom maestro:benefit uses ?much, which nothing binds",
        "maestro:benefit 60 | maestro:benefit 60 , 70"
            + " | prepareRoom maestro:benefit is stated more than once; keep one",
        "maestro:chance 0.9 | maestro:chance 1.5"
            + " | prepareRoom maestro:chance \"1.5\" is not a number from 0 to 1; write how likely",
        "maestro:chance 0.9 | maestro:chance \"good\""
            + " | prepareRoom maestro:chance \"good\" is not a number from 0 to 1",
        "\"PT10M\"^^xsd:duration | \"ten minutes\""
            + " | prepareRoom maestro:allowed \"ten minutes\" is not a duration; write days",
        "\"PT10M\"^^xsd:duration | \"PT0S\"^^xsd:duration"
            + " | prepareRoom maestro:allowed \"PT0S\" leaves no time; write days to seconds",
        "maestro:benefit 60 | maestro:benefitt 60 | prepareRoom maestro:benefitt is no known"
            + " property; write maestro:benefit, if that is meant",
        "maestro:benefit 60 | maestro:body \"(wait 1)\" | prepareRoom maestro:body is stated more"
            + " than once; join both with seq",
        "home:dim a maestro:Script ; | home:dim a maestro:Script . home:it a maestro:Script ;"
            + " | dim maestro:body is missing; write the steps in MAESTRO-SL in quotes",
        "home:prepareRoom a maestro:Script | home:move a maestro:Script"
            + " | move has the name of a word of the vocabulary; give it another name",
        "home:prepareRoom a maestro:Script | <https://example.org/x#rose> a maestro:Script"
            + " | rose has the local name of https://w3id.org/maestro/home/bob#rose; give it",
        "home:prepareRoom a maestro:Script | <https://example.org/x#dim> a maestro:Script"
            + " | dim has the local name of https://example.org/x#dim; give it another name",
        "home:prepareRoom a maestro:Script | home:prepareRoom a maestro:Script , maestro:Thing"
            + " | prepareRoom is a script and something else as well; give the script a name",
        "home:prepareRoom a maestro:Script ; | [] a maestro:Script ;"
            + " | has no name; give the script one, by which it is run",
      })
  void aFaultyScript(String right, String wrong, String expected) {
    assertThat(BOB).contains(right);
    assertFault(BOB.replace(right, wrong), expected);
  }

  @Test
  void aScriptMayBeWrittenAsThoseOfThePaperArePrinted() {
    Script evening = load(BOB + PRINTED).scripts().get("evening");

    assertThat(evening.form()).isEqualTo("(evening ?room - Zone ?who - Person)");
    assertThat(SlPrinter.print(evening.body()))
        .isEqualTo(
            "(let ?lux (run measured ?room)"
                + " (run prepareRoom ?room ?who) (run dim ?room ?lux) (run dim zone-b 0.5))");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "dim(room, lux) | dim(room lux) | evening maestro:printed in line 7 has \"room lux\" where an"
            + " argument is wanted; write a name, a number or a text in quotes",
        "name: lux | nam: lux | evening maestro:printed in line 4 declares the unknown kind nam",
        "script: evening | script: morning"
            + " | evening maestro:printed is headed by script: morning; write script: evening",
        "agent: who | agent: room2 | evening maestro:printed declares the agents (room, room2), and"
            + " maestro:arguments (room, who); name the same in both",
        "dim(room, lux) | dimm(room, lux)"
            + " | evening maestro:printed runs the unknown script dimm; write dim, if that is meant",
        "dim(zone-b | dim(zone-c"
            + " | evening maestro:printed names zone-c, which is not described; write zone-a",
        "dim(zone-b | dim(who | evening maestro:printed gives ?who for ?room of dim, which cannot be",
        "dim(zone-b, 0.5) | dim zone-b 0.5"
            + " | evening maestro:printed in line 8 is \"dim zone-b 0.5\", which is no call; write",
        "dim(zone-b, 0.5) | evening(room, who)"
            + " | evening maestro:printed runs itself without an end (evening, evening)",
        "maestro:printed | maestro:body \"(wait 1)\" ; maestro:printed"
            + " | evening maestro:printed is stated beside maestro:body; keep one of both",
        "maestro:printed | maestro:printed \"script: evening\" ; maestro:printed"
            + " | evening maestro:printed is stated more than once; keep one",
      })
  void aFaultyPrintedScript(String right, String wrong, String expected) {
    assertThat(PRINTED).contains(right);
    assertFault(BOB + PRINTED.replace(right, wrong), expected);
  }

  /** Each of them is told, with the whole way back to it. */
  @Test
  void scriptsThatRunEachOtherInAnyCaseNeverEnd() {
    String text =
        script("one", "", "(run other)")
            + script("other", "", "(seq (wait 1) (run third))").substring(BOB.length())
            + script("third", "", "(run one)").substring(BOB.length());

    assertFault(text, "one maestro:body runs itself without an end (one, other, third, one)");
    assertFault(text, "third maestro:body runs itself without an end (third, one, other, third)");
    assertThat(load(text.replace("(run third)", "(if (open door-ab) (run third))")).scripts())
        .containsKeys("one", "other", "third");
  }

  private static String script(String name, String parameters, String body) {
    return BOB
        + "home:%s a maestro:Script ; maestro:arguments ( %s ) ;\n  maestro:body \"%s\" .\n"
            .formatted(name, parameters, body);
  }

  private static void assertFault(String text, String expected) {
    HomeFaultException refusal = catchThrowableOfType(HomeFaultException.class, () -> load(text));
    assertThat(refusal).as(expected).isNotNull();
    assertThat(refusal.faults())
        .extracting(Fault::toString)
        .anyMatch(fault -> fault.contains(expected));
    Optional<Fault> told =
        refusal.faults().stream().filter(fault -> fault.toString().contains(expected)).findFirst();
    int before = (int) BOB.substring(0, BOB.indexOf("home:prepareRoom")).lines().count();
    assertThat(told.orElseThrow().line()).isGreaterThan(before);
  }

  private static Home load(String text) {
    return new HomeLoader().load(text, "bob.ttl");
  }
}
