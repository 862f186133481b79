package org.maestro.rats.protocol;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Who sends what is no message is told which field of it, which rule, and what was found. */
class RefusalsTest {

  private static final String CALL =
      "{'v':'1.0','id':'c1','boot':'b1','f':'pick','p':{},'t':5,'from':'cca',"
          + "'expects':{'cost':1,'seconds':2},'sent':{'clock':'k','ms':0}}";
  private static final String RESULT =
      "{'v':'1.0','id':'c1','from':'rose','outcome':'FAILED','z':'on','values':{},'error':{"
          + "'code':'INTERNAL','level':'ERROR','message':'why','retriable':false,'refs':["
          + "{'fact':'(on)','need':'true','have':'false'}]}}";
  private static final String PROGRESS =
      "{'v':'1.0','id':'c1','from':'rose','kind':'RUNNING','fraction':0.5,'values':{}}";
  private static final String STATUS = "{'v':'1.0','id':'rose','status':'ready','boot':'b1'}";
  private static final String STATE =
      "{'v':'1.0','id':'rose','boot':'b1','z':'on','values':['(on)'],'running':['c1'],"
          + "'queue':[],'disabled':['pick'],'recent':[{'id':'c0','outcome':'FAILED'}]}";

  private final WireFormat wire = new WireFormat();

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "'v':'1.0'|'v':'one'|v must be a text such as \"1.4\", but is \"one\"",
        "'v':'1.0'|'v':'2.0'|v must be of major version 1, but is 2.0",
        "'id':'c1'|'id':'c 1'|id must be 1 to 128 characters without space, but is \"c 1\"",
        "'id':'c1',|~~|id must be 1 to 128 characters without space, but is absent",
        "'cca'|'a/b'|from must be a name of letters, digits, '.', '_' and '-', at most 63, but is \"a/b\"",
        "'pick'|'a/b'|f must be 1 to 128 characters without space, '/', '+' and '#', but is \"a/b\"",
        "'t':5|'t':0|t must be a whole number from 1 to 604800000, but is 0",
        "'t':5|'t':5.5|t must be a whole number from 1 to 604800000, but is 5.5",
        "'t':5|'t':604800001|t must be a whole number from 1 to 604800000, but is 604800001",
        "'t':5|'t':18446744073709551621|t must be a whole number from 1 to 604800000, but is 18446744073709551621",
        "'t':5|'t':NaN|t must be a whole number from 1 to 604800000, but is \"NaN\"",
        "'ms':0|'ms':-1|sent.ms must be a whole number from 0 to 9223372036854775807, but is -1",
        "'k'|''|sent.clock must be 1 to 128 characters without space, but is \"\"",
        "'cost':1|'cost':-1|expects.cost must be a number from 0, but is -1",
        "'cost':1|'cost':'1'|expects.cost must be a number from 0, but is \"1\"",
        "'cost':1|'cost':NaN|expects.cost must be a number from 0, but is \"NaN\"",
        "'cost':1|'cost':1e999|expects.cost must be a number from 0, but is \"Infinity\"",
        "'seconds':2|'second':2|expects.seconds must be a number from 0, but is absent",
        "'p':{}|'p':[]|p must be an object, but is []",
        "'p':{}|'p':{'a':[1,null]}|p.a[1] must be a text, a finite number, true, false, a list or an object, but is null",
        "'p':{}|'p':{'a':'\\ud800'}|p.a must be of whole characters, but is one with half a character",
      })
  void ofACallNameFieldRuleAndFinding(String part, String wrong, String words) {
    assertRefused(wire::decodeCall, CALL, part, wrong, words);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "'FAILED'|'failed'|outcome must be one of CANCELED, FAILED, REJECTED, SUCCEEDED, TIMED_OUT, but is \"failed\"",
        "'values':{}|'values':[1]|values must be an object, but is [1]",
        "'code':'INTERNAL'|'code':'oops'|error.code must be a word of capital letters, digits and '_', at most 63, but is \"oops\"",
        "'ERROR'|'FATAL'|error.level must be one of ERROR, INFO, WARNING, but is \"FATAL\"",
        "'retriable':false|'retriable':'false'|error.retriable must be true or false, but is \"false\"",
        "'retriable':false,|~~|error.retriable must be true or false, but is absent",
        "'have':'false'|'have':{}|error.refs[0].have must be a text, a number, true or false, but is {}",
        "'need':'true',|~~|error.refs[0].need must be a text of at most 8192 characters, but is absent",
      })
  void ofAResultNameFieldRuleAndFinding(String part, String wrong, String words) {
    assertRefused(wire::decodeResult, RESULT, part, wrong, words);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "1.01|1.01",
        "-0.01|-0.01",
        "'1'|\"1\"",
        "null|null",
        "NaN|\"NaN\"",
        "1e999|\"Infinity\""
      })
  void ofAFractionNameItsLimits(String sent, String shown) {
    assertRefused(
        wire::decodeProgress,
        PROGRESS,
        "0.5",
        sent,
        "fraction must be a number from 0 to 1, but is " + shown);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "'(on)'|7|values[0] must be a text of at most 8192 characters, but is 7",
        "'c1'|'c1',''|running[1] must be 1 to 128 characters without space, but is \"\"",
        "'queue':[]|'queue':{}|queue must be a list, but is {}",
        "'outcome':'FAILED'|'outcome':'LOST'|recent[0].outcome must be one of CANCELED, FAILED, REJECTED, SUCCEEDED, TIMED_OUT, but is \"LOST\"",
        "'recent':[|'recent':[1,|recent[0] must be an object, but is 1",
      })
  void ofAStateNameFieldRuleAndFinding(String part, String wrong, String words) {
    assertRefused(wire::decodeState, STATE, part, wrong, words);
  }

  @Test
  void ofAStatusNameThePhases() {
    assertRefused(
        wire::decodeStatus,
        STATUS,
        "ready",
        "READY",
        "status must be one of disconnected, init, lost, ready, but is \"READY\"");
  }

  @Test
  void quoteSixtyCharactersOfWhatWasFound() {
    assertRefused(
        wire::decodeCall,
        CALL,
        "'c1'",
        "'c " + "1".repeat(80) + "'",
        "id must be 1 to 128 characters without space, but is \"c " + "1".repeat(57) + "...");
  }

  @Test
  void ofWhatIsNoJsonSayInOneLineWhyNot() {
    String rule = "The message's payload must be one JSON object nested at most 16 deep, but is ";
    assertThat(refusal(wire::decodeCall, CALL.replace("'p':{}", "'p':{'a':1,'a':2}")))
        .hasMessageStartingWith(rule + "not: Duplicate")
        .hasMessageMatching(".*");
    assertThat(refusal(wire::decodeCall, CALL.replace("'p'", "p")))
        .hasMessageStartingWith(rule + "not: Unexpected character ('p'")
        .hasMessageMatching(".*");
    byte[] noUtf32 = {0, 0, 0, '{', 0, 0x7f, 0, 0};
    assertThat(refusal(wire::decodeCall, noUtf32))
        .hasMessageStartingWith(rule + "not: Invalid UTF-32 character")
        .hasMessageMatching(".*");
  }

  @Test
  void ofWhatIsNoObjectSayNoMore() {
    for (String other : new String[] {"", " ", "[1]", "1", "'x'", "null"}) {
      assertThat(refusal(wire::decodeCall, other))
          .hasMessage("The message's payload must be one JSON object, but is something else");
    }
  }

  private static void assertRefused(
      Consumer<byte[]> decoder, String message, String part, String wrong, String words) {
    assertThat(message).contains(part);
    decoder.accept(bytes(message));
    assertThat(refusal(decoder, message.replace(part, wrong)))
        .hasMessage("The message's " + words)
        .extracting(MalformedMessageException::field)
        .isEqualTo(words.substring(0, words.indexOf(' ')));
  }

  private static MalformedMessageException refusal(Consumer<byte[]> decoder, String message) {
    return refusal(decoder, bytes(message));
  }

  private static MalformedMessageException refusal(Consumer<byte[]> decoder, byte[] message) {
    return catchThrowableOfType(MalformedMessageException.class, () -> decoder.accept(message));
  }

  private static byte[] bytes(String message) {
    return message.replace('\'', '"').getBytes(UTF_8);
  }
}
