(function(){var root=document.documentElement,buttons=document.querySelectorAll('button[data-set]');
function show(language){root.dataset.lang=language;root.lang=language;
buttons.forEach(function(button){button.setAttribute('aria-pressed',String(button.dataset.set===language))})}
buttons.forEach(function(button){button.addEventListener('click',function(){show(button.dataset.set)})});
var wanted=(navigator.languages&&navigator.languages[0])||navigator.language||'en';
show(wanted.toLowerCase().indexOf('ja')===0?'ja':'en')})();
